/// Sends changed texts to the server: one is under way, and of each file the newest waits.
import { connection, deferred, problems, textUnderWay, textVersion } from '../state/state';
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

function answered(): void {
    asked = 0;
    textUnderWay.value = waiting.size > 0;
    sendNext();
}

/// Takes note of the server's answers; to be called once.
export function watchAnswers(): void {
    problems.subscribe((list) => {
        if (list && asked !== 0 && list.v >= asked) {
            answered();
        }
    });
    deferred.subscribe((one) => {
        if (one && asked !== 0 && one.v >= asked) {
            answered();
        }
    });
    // After a connection was lost, the files that the server tells anew show which texts it lacks.
    connection.subscribe((state) => {
        if (state !== 'open') {
            asked = 0;
            textUnderWay.value = waiting.size > 0;
        }
    });
}
