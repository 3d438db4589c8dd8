/// Forgets the changes of the open shot, when the user leaves it without saving.
import { send } from '../connection/socket';
import { textVersion } from '../state/state';
import { buffers, isChanged } from './buffers';
import { forgetStored } from './session_store';
import { setSteps } from './steps';

/// The page forgets its texts, and the server those that differ from the files on disk; it tells
/// the files anew.
export function discardTexts(): void {
    const [shot] = buffers.value;
    for (const { file } of buffers.value.filter((one) => one.writable && isChanged(one))) {
        textVersion.value += 1;
        send('revert', { v: textVersion.value, file });
    }
    if (shot) {
        forgetStored(shot.file);
    }
    buffers.value = [];
    setSteps([], []);
}
