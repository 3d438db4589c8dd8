/// Scenes of the older text format: chosen or dropped on the page, converted by the server, and
/// then written to a new shot, put into the open one, or taken apart.
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { ask } from '../dialogs/open_dialogs';
import type { Imported } from '../protocol';
import { isStarting, notice } from '../state/state';
import { bufferOf, buffers, typeStep } from '../text/buffers';
import { writeShot } from './file_actions';
import { addParts } from './AddParts';
import { freeName } from './shot_name';

const kMostBytes = 3_000_000;  // of a scene; the server takes messages of up to 4 MiB

/// Reads a file of the user's and asks the server to convert it.
async function importFile(file: File): Promise<void> {
    if (file.size > kMostBytes) {
        notice.value = { kind: 'error', text: `${file.name} is too large for a scene.` };
        return;
    }
    send('import', { name: file.name, text: await file.text() });
}

/// Lets the user choose a scene to import.
export function chooseScene(): void {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = '.txt,.scene,text/plain';
    input.onchange = () => {
        const file = input.files?.[0];
        if (file) {
            void importFile(file);
        }
    };
    input.click();
}

function Notes({ imported }: { imported: Imported }) {
    return (
        <>
            {imported.yaml === '' ? <p>The scene has errors and was not converted.</p> : (
                <p>
                    The scene is converted to a shot. What could not be kept exactly is also in
                    comments of the text.
                </p>
            )}
            {imported.problems.length > 0
                ? <ul class="notes errors">{imported.problems.map((one) => <li>{one}</li>)}</ul>
                : null}
            {imported.notes.length > 0
                ? <ul class="notes">{imported.notes.map((one) => <li>{one}</li>)}</ul> : null}
        </>
    );
}

/// Makes the imported text that of the open shot, as one step of undo.
function replaceText(yaml: string): void {
    const file = buffers.value[0]?.file ?? '';
    const buffer = bufferOf(file);
    if (buffer) {
        typeStep([{ file, changes: { from: 0, to: buffer.state.doc.length, insert: yaml } }],
            'Import a scene');
    }
}

async function offer(imported: Imported): Promise<void> {
    const stem = imported.name.replace(/\.[^.]*$/, '');
    const answers = imported.yaml === '' ? [{ label: 'Close' }] : [
        { label: 'New shot', about: 'Write it to a file of its own and open that' },
        ...isStarting.value ? [] : [
            { label: 'Add some of it…', about: 'Choose what to add to the open shot' },
            { label: 'Replace this shot', about: 'It becomes the text of the open shot' },
        ],
    ];
    const body = () => <Notes imported={imported} />;
    const answer = await ask(`Import ${imported.name}`, body, answers);
    if (answer === 'New shot') {
        await writeShot(`${freeName(stem, [])}.yaml`, imported.yaml);
    } else if (answer === 'Replace this shot') {
        replaceText(imported.yaml);
    } else if (answer === 'Add some of it…') {
        await addParts({ file: '', text: imported.yaml, name: imported.name });
    }
}

/// Takes a file that is dropped on the page, or a YAML file's parts, before the text editor does, which
/// would type its text. To be called once.
export function watchDrops(): void {
    onMessage('imported', (imported) => { void offer(imported); });
    const isFile = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
    addEventListener('dragover', (event) => {
        if (isFile(event)) {
            event.preventDefault();
        }
    });
    addEventListener('drop', (event) => {
        const file = event.dataTransfer?.files[0];
        if (!isFile(event) || !file) {
            return;
        }
        event.preventDefault();
        event.stopPropagation();
        if (/\.ya?ml$/.test(file.name)) {
            void file.text().then((text) => isStarting.value
                ? writeShot(file.name, text) : addParts({ file: '', text, name: file.name }));
        } else {
            void importFile(file);
        }
    }, true);
}

