/// The panel of documents: plan, report, speeds and energy, contact sheet, and exports.
import { withKey } from '../connection/key';
import { useEffect } from 'preact/hooks';
import { Dialog, type DialogAction } from '../dialogs/Dialog';
import { hasErrors, isStale, panel, timeline } from '../state/state';
import { hasUnsaved } from '../start/file_actions';
import {
    documentKinds, documentProblem, look, looks, making, shownDocument, stopMaking, written, type DocumentKind,
} from './documents_state';
import { ExportForm } from './ExportForm';
import { kTitles } from './formats';
import '../films/films.css';
import './documents.css';

const kNoSheet = 'A contact sheet shows frames of the film, which have to be rendered. '
    + 'It is made of the saved shot.';

function walk(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step) {
        event.preventDefault();
        const kinds = documentKinds.peek();
        const at = (kinds.indexOf(shownDocument.value) + step + kinds.length) % kinds.length;
        shownDocument.value = kinds[at] ?? 'plan';
        document.getElementById(`document-${shownDocument.value}`)?.focus();
    }
}

function Tabs() {
    return (
        <div class="tabs" role="tablist" aria-label="Documents" onKeyDown={walk}>
            {documentKinds.value.map((kind) => {
                const isShown = shownDocument.value === kind;
                return (
                    <button key={kind} type="button" role="tab" id={`document-${kind}`}
                        aria-selected={isShown} aria-controls="document" tabIndex={isShown ? 0 : -1}
                        data-focus={isShown ? '' : undefined}
                        onClick={() => { shownDocument.value = kind; }}>{kTitles[kind]}</button>
                );
            })}
        </div>
    );
}

/// What is being made, as a sentence.
function MakingText() {
    const work = making.value;
    if (!work) {
        return null;
    }
    const stage = work.stage === 'bake' ? 'simulating' : work.stage === 'render' ? 'rendering' : 'working';
    return (
        <p class="making" role="status">
            {stage}: {Math.round(100 * work.fraction)} %
            <button type="button" class="link" onClick={stopMaking}>Stop</button>
        </p>
    );
}

/// The document as it was made last.
function Shown({ kind }: { kind: DocumentKind }) {
    const made = looks.value.get(kind);
    if (!made) {
        return (
            <div class="sheet">
                {kind === 'contact_sheet' ? <p class="nothing">{kNoSheet}</p> : null}
            </div>
        );
    }
    if (kind === 'report') {
        return <pre class="sheet" tabIndex={0} aria-label="The report">{made.text}</pre>;
    }
    return (
        <div class="sheet" tabIndex={0} role="region" aria-label={kTitles[kind]}>
            <img src={withKey(made.address)} alt={kTitles[kind]} class={kind} />
        </div>
    );
}

/// Asks for the document again whenever there is a newer motion.
function useLook(kind: DocumentKind): void {
    const v = isStale.value ? 0 : timeline.value?.head.v ?? 0;
    useEffect(() => {
        const made = looks.peek().get(kind);
        // The contact sheet renders frames of the file on disk: that is for the user to ask.
        const isQuick = kind !== 'contact_sheet' && kind !== 'export';
        if (v > 0 && isQuick && made?.v !== v) {
            void look(kind);
        }
    }, [kind, v]);
}

export function DocumentsPanel() {
    const kind = shownDocument.value;
    useLook(kind);
    const isOff = making.value !== null || hasErrors.value;
    const actions: DialogAction[] = kind === 'contact_sheet' ? [{
        label: hasUnsaved() ? 'Save and make' : looks.value.has(kind) ? 'Make again' : 'Make',
        isDisabled: isOff, about: 'Renders the frames that are new or have changed',
        run: () => (void look(kind), false),
    }] : [];
    return (
        <Dialog title={kTitles[kind]} size="full" actions={actions}
            onClose={() => { stopMaking(); panel.value = null; }}>
            <div class="document">
                <Tabs />
                <div id="document" role="tabpanel" aria-labelledby={`document-${kind}`}>
                    {hasErrors.value ? (
                        <p class="error">The shot has errors. This shows its last version without errors.</p>
                    ) : null}
                    {kind === 'export' ? null : <Shown kind={kind} />}
                    {documentProblem.value
                        ? <p class="error" role="alert">{documentProblem.value}</p> : null}
                    <MakingText />
                    <ExportForm key={kind} kind={kind} isOff={isOff} />
                    {written.value ? (
                        <p class="written" role="status">
                            {written.value.file} was written.{' '}
                            <a class="download" href={withKey(written.value.address)}
                                download={written.value.file.split('/').pop()}>Download</a>
                        </p>
                    ) : null}
                </div>
            </div>
        </Dialog>
    );
}
