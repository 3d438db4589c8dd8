/// Sends changed texts to the server: one is under way, and of each file the newest waits.
import { connection, problems, textUnderWay, textVersion } from '../state/state';
import { send } from '../connection/socket';
import { bufferOf, textOf } from './buffers';

const waiting = new Set<string>();
let asked = 0;  // the version under way; 0: none

function sendNext(): void {
    const [file] = waiting;
    const buffer = file === undefined ? undefined : bufferOf(file);
    if (file === undefined || asked !== 0 || connection.value !== 'open') {
        return;
    }
    waiting.delete(file);
    if (!buffer) {
        return;
    }
    const v = textVersion.value + 1;
    if (send('text', { v, file, text: textOf(buffer) })) {
        asked = v;
        textVersion.value = v;
    } else {
        waiting.add(file);
    }
}

/// Sends the text of a file as soon as the server has answered the one before.
export function sendSoon(file: string): void {
    waiting.add(file);
    textUnderWay.value = true;
    queueMicrotask(sendNext);
}

/// Takes note of the server's answers; to be called once.
export function watchAnswers(): void {
    problems.subscribe((list) => {
        if (list && asked !== 0 && list.v >= asked) {
            asked = 0;
            textUnderWay.value = waiting.size > 0;
            sendNext();
        }
    });
    connection.subscribe((state) => {
        if (state !== 'open') {
            asked = 0;
        }
    });
}
