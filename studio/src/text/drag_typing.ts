/// The texts that a drag shows: those from before it with what it changes in them. What comes into a
/// text from elsewhere meanwhile, such as from another window, is kept beside that.
import { currentFiles, textOfDocument } from '../edit/current_files';
import type { SourceFile } from '../edit/edit_types';
import { mergeWords, type Merged } from '../edit/merge_lines';
import { difference, type TextEdit } from '../edit/text_edit';
import type { EditorState } from '@codemirror/state';
import { notice } from '../state/state';
import { bufferOf, type FileChange } from './buffers';
import { OutsideTyping } from './outside_typing';

export class DragTyping {
    /// The texts when the drag began.
    readonly origin: SourceFile[] = currentFiles();
    private readonly typing = new OutsideTyping();
    private target: readonly SourceFile[] = this.origin;

    hasTyped(file: string): boolean {
        return this.typing.hasTyped(file);
    }

    /// Whether nothing but the drag, and what `rebase` let through, changed the texts.
    get isAlone(): boolean {
        return this.typing.isAlone;
    }

    /// A file without what the drag typed.
    stateBefore(file: string): EditorState | undefined {
        return this.typing.stateBefore(file);
    }

    /// Types what makes `target` of the texts in `origin`.
    show(target: readonly SourceFile[]): void {
        this.target = target;
        for (const { file } of target) {
            this.type(file, this.merged(file).text);
        }
    }

    /// Lets `change` change a file as if there were no drag, then types again on top of that. Where
    /// both change the same lines, the user is told, and sees what came until the drag goes on.
    rebase(file: string, change: () => void): void {
        this.typing.takeBackIn(file);
        change();
        const { text, conflicts } = this.merged(file);
        if (conflicts === 0) {
            this.type(file, text);
            return;
        }
        tellOfConflict();
    }

    /// Takes everything back. Returns what makes it again, as a step of undo; nothing if something
    /// else changed the texts, too.
    finish(): FileChange[] {
        const typed = this.origin.filter(({ file }) => this.hasTyped(file))
            .map(({ file }) => ({ file, text: this.merged(file).text }));
        const isWhole = this.isAlone;
        this.typing.takeBack();
        return typed.flatMap(({ file, text }) => {
            const changes = isWhole ? this.editTo(file, text) : null;
            return changes ? [{ file, changes }] : [];
        });
    }

    private type(file: string, text: string): void {
        const edit = this.editTo(file, text);
        if (edit) {
            this.typing.type(file, edit);
        }
    }

    private editTo(file: string, text: string): TextEdit | null {
        const document = bufferOf(file)?.state.doc;
        return document ? difference(textOfDocument(document), text) : null;
    }

    /// The text as it would be without the drag, with what the drag changes.
    private merged(file: string): Merged {
        const textIn = (all: readonly SourceFile[]) => all.find((one) => one.file === file)?.text;
        const state = this.stateBefore(file);
        const now = state ? textOfDocument(state.doc) : '';
        const [before = now, wanted = now] = [textIn(this.origin), textIn(this.target)];
        return mergeWords(before, wanted, now);
    }
}

/// Tells that two windows changed the same, so that one of both changes is lost.
export function tellOfConflict(): void {
    notice.value = {
        kind: 'info', text: 'Another window changed the same lines: what was changed last counts.',
    };
}
