/// The texts of which the page shows the scene: those of the last version without errors.
import type { SourceFile } from '../edit/edit_types';
import { currentFiles } from '../edit/current_files';
import { sequence, shot, textVersion } from '../state/state';

const noted = new Map<number, SourceFile[]>();  // by their version, which increases

/// Takes note that the server has, or gets, the texts as they are now under the newest version.
export function noteTexts(): void {
    const shown = (sequence.peek() ?? shot.peek())?.v ?? 0;
    const older = [...noted.keys()].filter((v) => v <= shown).slice(0, -1);
    older.forEach((v) => noted.delete(v));
    noted.delete(textVersion.peek());
    noted.set(textVersion.peek(), currentFiles());
}

/// Versions may begin anew.
export function forgetNoted(): void {
    noted.clear();
}

/// The texts of the scene that is shown; null if none is, or they are not known.
export function shownTexts(): SourceFile[] | null {
    const shown = (sequence.peek() ?? shot.peek())?.v;
    const versions = shown === undefined ? [] : [...noted.keys()].filter((v) => v <= shown);
    return noted.get(Math.max(...versions)) ?? null;
}
