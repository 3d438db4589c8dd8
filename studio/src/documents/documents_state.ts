/// Drawings, the report, pictures and exports of the shot, which the server makes.
import { withKey } from '../connection/key';
import { computed, signal } from '@preact/signals';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { ask } from '../dialogs/open_dialogs';
import type { Made, Make, Making } from '../protocol';
import { isSequence, notice, panel } from '../state/state';
import { formatsOf } from './formats';
import { saveIfChanged } from '../start/file_actions';
import { existsQuestion } from '../start/questions';

export type DocumentKind = 'plan' | 'report' | 'plot' | 'contact_sheet' | 'export';
/// What is asked for, without what only the connection needs.
export type Wanted = Pick<Make, 'what' | 'output' | 'frame' | 'rate'>;

export const shownDocument = signal<DocumentKind>('plan');
/// What was made to look at, by kind; of the report also its text.
export const looks = signal<ReadonlyMap<string, Made & { text: string }>>(new Map());
/// What is being made; null: nothing.
export const making = signal<(Making & { what: string; isToLook: boolean }) | null>(null);
/// Why the last one could not be made, as a sentence; empty: nothing.
export const documentProblem = signal('');
/// The last file that was written.
export const written = signal<Made | null>(null);

let lastQ = 0;
/// What was asked for last, for the question whether a file may be replaced.
let last: Wanted | null = null;

const kKinds: readonly DocumentKind[] = ['plan', 'report', 'plot', 'contact_sheet', 'export'];

/// The documents that there are of what is open.
export const documentKinds = computed(() =>
    kKinds.filter((kind) => formatsOf(kind, isSequence.value).length > 0));

/// Shows one of the documents, or the first one of those that there are.
export function openDocuments(kind: DocumentKind): void {
    const kinds = documentKinds.peek();
    shownDocument.value = kinds.includes(kind) ? kind : kinds[0] ?? kind;
    panel.value = 'documents';
}

function request(wanted: Wanted, overwrite: boolean): void {
    lastQ += 1;
    last = wanted;
    documentProblem.value = '';
    written.value = null;
    const isSent = send('make', { q: lastQ, ...wanted, overwrite });
    making.value = isSent ? { q: lastQ, stage: '', fraction: 0, what: wanted.what,
        isToLook: wanted.output === '' } : null;
    if (!isSent) {
        documentProblem.value = 'There is no connection to the server.';
    }
}

/// Asks for a document to look at.
export async function look(what: DocumentKind): Promise<void> {
    if (what !== 'contact_sheet' || await saveIfChanged()) {
        request({ what, output: '', frame: 0, rate: 0 }, false);
    }
}

/// Saves the shot, and asks for a file. One that exists is only replaced after a question.
export async function write(wanted: Wanted): Promise<void> {
    if (await saveIfChanged()) {
        request(wanted, false);
    }
}

export function stopMaking(): void {
    if (making.value) {
        send('stop_making', { q: making.value.q });
    }
}

async function take(made: Made): Promise<void> {
    const isNewest = made.q === making.value?.q;
    const text = made.what === 'report' && made.file === ''
        ? await (await fetch(withKey(made.address))).text() : '';
    if (made.file === '') {
        looks.value = new Map(looks.value).set(made.what, { ...made, text });
    } else {
        written.value = made;
        notice.value = { kind: 'info', text: `${made.file} was written.` };
    }
    if (isNewest) {
        making.value = null;
    }
}

/// Takes what the server answers; to be called once.
export function watchDocuments(): void {
    onMessage('welcome', () => {
        looks.value = new Map();
        making.value = null;
        written.value = null;
    });
    onMessage('making', (message) => {
        if (making.value?.q === message.q) {
            making.value = { ...making.value, ...message };
        }
    });
    onMessage('made', (made) => { void take(made); });
    onMessage('exists', ({ what, name }) => {
        if (what === 'make' && last) {
            const again = last;
            making.value = null;
            void ask(`${name} exists already`, existsQuestion(name),
                [{ label: 'Keep it' }, { label: 'Overwrite', kind: 'danger' }]).then((answer) => {
                if (answer === 'Overwrite') {
                    request(again, true);
                }
            });
        }
    });
    onMessage('failed', ({ what, message }) => {
        if (what === 'make' && making.value) {
            making.value = null;
            documentProblem.value = message;
        }
    });
}
