/// Chooses the format and the name of a file, and has it written.
import { useSignal } from '@preact/signals';
import { filmTime, folderOfFiles, isSequence, openFilm, welcome } from '../state/state';
import { hasUnsaved } from '../start/file_actions';
import { write, type DocumentKind } from './documents_state';
import { formatsOf, problemOfOutput, withEnding, type Format } from './formats';

/// The name of the shot's file without its ending.
function stem(): string {
    return (welcome.value?.shot.split('/').pop() ?? 'shot').replace(/\.ya?ml$/, '');
}

/// The number of the film's frame at the play head.
function frameNow(): number {
    const film = openFilm.value;
    const frame = film ? Math.floor(filmTime.value * film.fps + 1e-6) : 0;
    return Math.max(0, Math.min(frame, (film?.frames ?? 1) - 1));
}

function suggested(format: Format): string {
    const number = format.what === 'frame' ? `_${String(frameNow()).padStart(4, '0')}` : '';
    const name = `${stem()}${format.suffix}${number}${format.endings[0]}`;
    return name === welcome.value?.shot.split('/').pop() ? withEnding(`${stem()}_motion`, '.json') : name;
}

interface Properties {
    kind: DocumentKind;
    isOff: boolean;
}

export function ExportForm({ kind, isOff }: Properties) {
    const formats = formatsOf(kind, isSequence.value);
    const chosen = useSignal(0);
    const format = formats[chosen.value] ?? formats[0];
    const typed = useSignal('');  // empty: the suggested name
    const rate = useSignal('');
    if (!format) {
        return null;
    }
    const name = typed.value || suggested(format);
    const samples = rate.value.trim() === '' ? 0 : Number(rate.value);
    const problem = problemOfOutput(name, format.endings)
        || (samples >= 0 ? '' : 'Write the rate as a number of samples per second.');
    const submit = () => {
        void write({ what: format.what, output: name.trim(), frame: frameNow(), rate: samples });
    };
    const onKey = (event: KeyboardEvent) => {
        if (event.key === 'Enter' && !isOff && problem === '') {
            event.preventDefault();
            submit();
        }
    };
    return (
        <div class="export">
            {formats.length < 2 ? null : (
                <fieldset>
                    <legend>What to export</legend>
                    {formats.map((one, i) => (
                        <label key={one.label}>
                            <input type="radio" name="format" checked={chosen.value === i}
                                onChange={() => { chosen.value = i; typed.value = ''; rate.value = ''; }} />
                            <span><b>{one.label}</b> <code>{one.endings.join(' ')}</code><i>{one.about}</i></span>
                        </label>
                    ))}
                </fieldset>
            )}
            <div class="file" onKeyDown={onKey}>
                <label class="name">
                    <span>File (in {folderOfFiles.value})</span>
                    <input type="text" value={name} spellcheck={false} autocomplete="off"
                        aria-invalid={problem !== ''}
                        onInput={(event) => { typed.value = event.currentTarget.value; }} />
                </label>
                {format.hasRate ? (
                    <label class="rate">
                        <span>Samples per second</span>
                        <input type="text" inputMode="decimal" placeholder="as many keys as needed"
                            value={rate.value} autocomplete="off"
                            onInput={(event) => { rate.value = event.currentTarget.value; }} />
                    </label>
                ) : null}
                <button type="button" class="action primary" disabled={isOff || problem !== ''}
                    onClick={submit}>{hasUnsaved() ? 'Save the shot and write' : 'Write'}</button>
            </div>
            <p class="where">{problem || (formats.length < 2 ? `${format.about} The ending chooses the format: ${format.endings.join(', ')}.` : '')}</p>
        </div>
    );
}
