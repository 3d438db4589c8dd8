/// What one drag types outside of the histories, and how it is taken back: with the histories of
/// before, as typing back would move the places of older steps that changed the same characters.
import type { ChangeSpec, EditorState, Text } from '@codemirror/state';
import { bufferOf, restore, typeOutside } from './buffers';

export class OutsideTyping {
    private readonly before = new Map<string, EditorState>();
    private readonly typed = new Map<string, Text>();

    hasTyped(file: string): boolean {
        return this.before.has(file);
    }

    /// A file without what was typed here.
    stateBefore(file: string): EditorState | undefined {
        return this.before.get(file) ?? bufferOf(file)?.state;
    }

    type(file: string, changes: ChangeSpec): void {
        const state = bufferOf(file)?.state;
        if (state) {
            this.before.set(file, this.before.get(file) ?? state);
            typeOutside(file, changes);
            this.typed.set(file, bufferOf(file)?.state.doc ?? state.doc);
        }
    }

    /// Whether nothing else changed the files that this typed into.
    get isAlone(): boolean {
        return [...this.typed.keys()].every((file) => this.isOwn(file));
    }

    /// Restores the files, except those that something else changed, too.
    takeBack(): void {
        [...this.before.keys()].forEach((file) => this.takeBackIn(file));
    }

    /// Restores one file, as if nothing had been typed into it.
    takeBackIn(file: string): void {
        const state = this.before.get(file);
        if (state && this.isOwn(file)) {
            restore(file, state);
        }
        this.before.delete(file);
        this.typed.delete(file);
    }

    private isOwn(file: string): boolean {
        return bufferOf(file)?.state.doc === this.typed.get(file);
    }
}
