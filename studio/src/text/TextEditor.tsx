/// The text editor: one tab for each file of the shot.
import { closeBrackets, closeBracketsKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, indentWithTab } from '@codemirror/commands';
import { yaml } from '@codemirror/lang-yaml';
import {
    bracketMatching, codeFolding, foldGutter, foldKeymap, indentOnInput,
} from '@codemirror/language';
import { diagnosticCount, lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { EditorState, Prec } from '@codemirror/state';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import {
    drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers,
} from '@codemirror/view';
import { effect } from '@preact/signals';
import { Lock, TriangleAlert } from 'lucide-preact';
import { useEffect, useRef } from 'preact/hooks';
import { openMerge } from '../dialogs/merge_dialog';
import { problems } from '../state/state';
import {
    activeFile, afterTransaction, attachView, bufferOf, buffers, isChanged, setChangeListener, type Buffer,
} from './buffers';
import { completion } from './complete/source';
import { conflictOf } from './disk_conflicts';
import { dashInput } from './dash_input';
import { editorLook } from './editor_look';
import { selectAtCursor, showSelection } from './follow_selection';
import { goToMeaning } from './go_to';
import { yamlLook } from './highlight';
import { hoverAbout } from './hover';
import { indentGuides } from './indent_guides';
import { pageNonce } from './nonce';
import { marksIn, marksOf } from './problem_marks';
import { ProblemList } from './ProblemList';
import { saveAll, writeAgain } from './saving';
import { scrub } from './scrub';
import { findPanel } from './search_panel';
import { sendSoon } from './sending';
import { setShownView } from './show';
import { makeState, setExtensions } from './states';
import { swatches } from './swatches';
import { tooltipLook } from './tooltip_look';
import { undoStep } from './undo_commands';
import './find.css';
import './text.css';

/// The arrow in the gutter beside what can be folded.
function foldMarker(isOpen: boolean): HTMLElement {
    const marker = document.createElement('span');
    marker.className = isOpen ? 'open' : 'folded';
    marker.textContent = isOpen ? '⌄' : '›';
    marker.title = isOpen ? 'Fold' : 'Unfold';
    return marker;
}

const keys = keymap.of([
    { key: 'Mod-z', run: () => undoStep(true), preventDefault: true },
    { key: 'Mod-y', run: () => undoStep(false), preventDefault: true },
    { key: 'Mod-Shift-z', run: () => undoStep(false), preventDefault: true },
    { key: 'Mod-s', run: () => (saveAll(), true), preventDefault: true },
    ...closeBracketsKeymap, ...searchKeymap, ...foldKeymap,
    ...lintKeymap.filter(({ key }) => key === 'F8'),  // Ctrl-Shift-M is the page's own list
    ...defaultKeymap.filter(({ key }) => key !== 'Mod-Enter'), indentWithTab,
]);

/// The undo and redo of the browser's menus.
const menuUndo = Prec.highest(EditorView.domEventHandlers({
    beforeinput: (event) => {
        const isUndo = event.inputType === 'historyUndo';
        if (!isUndo && event.inputType !== 'historyRedo') {
            return false;
        }
        event.preventDefault();
        undoStep(isUndo);
        return true;
    },
}));

setExtensions(() => [
    EditorView.cspNonce.of(pageNonce()),
    EditorState.allowMultipleSelections.of(true), lineNumbers(), highlightActiveLine(), highlightActiveLineGutter(), drawSelection(),
    highlightSelectionMatches(), bracketMatching(), indentOnInput(), lintGutter(),
    completion(), closeBrackets(), dashInput, yaml(), yamlLook, tooltipLook, hoverAbout, editorLook,
    codeFolding(), foldGutter({ markerDOM: foldMarker }), search({ top: true, createPanel: findPanel }), indentGuides,
    swatches, scrub, goToMeaning, keys, menuUndo, selectAtCursor,
    EditorView.contentAttributes.of({ 'aria-label': 'Text of the shot', tabindex: '0' }),
]);
setChangeListener(sendSoon);

/// Makes the view, and keeps it at the active file and its problems. Returns what ends this.
function openView(parent: HTMLElement): () => void {
    let shown: Buffer | undefined;
    const view = new EditorView({
        parent,
        state: makeState('', false),  // with the nonce from the start
        dispatchTransactions: (transactions, target) => {
            target.update(transactions);
            for (const transaction of transactions) {
                afterTransaction(shown?.file ?? '', transaction);
            }
        },
    });
    attachView(view);
    window.studio['editor'] = { view, marks: () => marksIn(view.state) };
    setShownView(view);
    const marked = new Set<string>();  // files; a mark in the gutter outlives the text that it was for
    const mark = () => {
        const list = problems.peek()?.list ?? [];
        if (shown) {
            const marks = marksOf(view.state.doc, shown.file, list);
            if (marks.length > 0 || marked.has(shown.file) || diagnosticCount(view.state) > 0) {
                view.dispatch(setDiagnostics(view.state, marks));
            }
            marked[marks.length > 0 ? 'add' : 'delete'](shown.file);
        }
    };
    const stopFile = effect(() => {
        const buffer = buffers.value.find(({ file }) => file === activeFile.value);
        if (buffer && buffer !== shown) {
            shown = buffer;
            view.setState(buffer.state);
            view.scrollDOM.scrollTo(0, 0);
            mark();
        }
    });
    const stopProblems = problems.subscribe(mark);
    const stopSelection = showSelection(view);
    return () => {
        stopFile();
        stopSelection();
        stopProblems();
        attachView(null);
        setShownView(null);
        view.destroy();
    };
}

/// A mark on the tab of a file with problems.
function ProblemMark({ file }: { file: string }) {
    const own = (problems.value?.list ?? []).filter(({ place }) => place.file === file);
    const isError = own.some(({ severity }) => severity === 'error');
    return own.length === 0 ? null
        : <span class={isError ? 'mark' : 'mark warning'} title={`${own.length} problems`} />;
}

function Tabs() {
    return (
        <div class="tabs" role="tablist" aria-label="Files of the shot">
            {buffers.value.map((buffer) => (
                <button
                    key={buffer.file}
                    role="tab"
                    class="tab"
                    aria-selected={buffer.file === activeFile.value}
                    title={buffer.writable ? buffer.file : `${buffer.file} (read-only)`}
                    onClick={() => { activeFile.value = buffer.file; }}
                >
                    {buffer.writable ? null : <Lock size={12} aria-label="read-only" />}
                    {buffer.name.slice(buffer.name.lastIndexOf('/') + 1)}
                    <ProblemMark file={buffer.file} />
                    {buffer.writable && isChanged(buffer) ? <span class="dot" title="not saved" /> : null}
                </button>
            ))}
        </div>
    );
}

/// Says that another program changed the shown file, or took it away, until the user has merged both
/// texts or written the file again.
function ConflictBar() {
    const conflict = conflictOf(activeFile.value);
    const isWritable = bufferOf(activeFile.value)?.writable ?? false;
    return conflict ? (
        <div class="conflict" role="alert">
            <TriangleAlert size={14} aria-hidden="true" />
            <span>{conflict.gone === '' ? 'Another program changed this file.'
                : `This file ${conflict.gone}.`}</span>
            {conflict.gone === ''
                ? <button onClick={() => openMerge(conflict, null)}>Compare</button>
                : isWritable
                    ? <button onClick={() => writeAgain(conflict.file)}>Write it again</button> : null}
        </div>
    ) : null;
}

/// The editor with its tabs; fills its parent.
export function TextEditor() {
    const parent = useRef<HTMLDivElement>(null);
    useEffect(() => (parent.current ? openView(parent.current) : undefined), []);
    return (
        <section class="text-area" aria-label="Text">
            <Tabs />
            <ConflictBar />
            <div class="text-view" ref={parent} />
            <ProblemList />
        </section>
    );
}
