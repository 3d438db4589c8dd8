/// Forgets the changes of the open shot, when the user leaves it without saving: once the server has
/// opened another one, as it may refuse.
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { textVersion } from '../state/state';
import { buffers, isChanged } from './buffers';
import { holdSending, sendSoon } from './sending';
import { forgetStored } from './session_store';
import { setSteps } from './steps';

let leaving = '';  // the shot that is being left without saving; empty: none
let isAgain = false;  // it is to be opened anew

function changedFiles(): string[] {
    return buffers.value.filter((one) => one.writable && isChanged(one)).map(({ file }) => file);
}

/// The server forgets the changed texts, so that it does not offer them again; the page keeps them
/// until it shows another shot. To be followed by the request to open `next`.
export function leaveTexts(next: string): void {
    leaving = buffers.value[0]?.file ?? '';
    isAgain = next === leaving;
    holdSending(true);
    for (const file of changedFiles()) {
        textVersion.value += 1;
        send('revert', { v: textVersion.value, file });
    }
}

/// The page forgets its texts, too.
function forgetTexts(): void {
    forgetStored(leaving);
    leaving = '';
    buffers.value = [];
    setSteps([], []);
    holdSending(false);
}

/// The server gets the texts again.
function stay(): void {
    if (leaving !== '') {
        leaving = '';
        changedFiles().forEach(sendSoon);
        holdSending(false);
    }
}

/// Listens to what becomes of it; to be called once.
export function watchLeaving(): void {
    onMessage('welcome', ({ shot }) => {
        if (leaving !== '' && (isAgain || shot !== leaving)) {
            forgetTexts();
        } else {
            stay();
        }
    });
    onMessage('exists', stay);
    onMessage('failed', ({ what }) => what === 'open' && stay());
}
