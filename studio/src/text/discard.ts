/// Forgets the changes of the open shot, when the user leaves it without saving: once the server has
/// opened another one, as it may refuse.
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { textVersion } from '../state/state';
import { buffers, isChanged } from './buffers';
import { sendSoon } from './sending';
import { forgetStored } from './session_store';
import { setSteps } from './steps';

let leaving = '';  // the shot that is being left without saving; empty: none
let isAgain = false;  // it is to be opened anew

/// Whether texts that the server lacks are kept from it, because they are to be forgotten.
export function isLeaving(): boolean {
    return leaving !== '';
}

function changedFiles(): string[] {
    return buffers.value.filter((one) => one.writable && isChanged(one)).map(({ file }) => file);
}

/// The server forgets the changed texts, so that it does not offer them again; the page keeps them
/// until it shows another shot. To be followed by the request to open `next`.
export function leaveTexts(next: string): void {
    leaving = buffers.value[0]?.file ?? '';
    isAgain = next === leaving;
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
}

/// The server gets the texts again.
function stay(): void {
    if (leaving !== '') {
        leaving = '';
        changedFiles().forEach(sendSoon);
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
