/// Numbers in the text change by a drag with Alt, and by Ctrl with the arrow keys: by one of their
/// last digit, ten with Shift.
import type { EditorState, Extension } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';
import { parseQuantity, writeLike } from '../edit/quantity';
import { applyEdits } from '../edit/text_edit';
import { activeFile, typeStep } from './buffers';
import { DragTyping } from './drag_typing';
import { hoveredAt } from './hover';
import { startDrag, stopDrag, type LiveDrag } from './live_drag';

interface NumberInText {
    from: number;
    text: string;
    /// The last key on the way to it.
    name: string;
}

const kPixels = 4;  // of a drag for one step

/// The number at an offset; null if there is none that could be changed in steps.
export function numberAt(state: EditorState, offset: number): NumberInText | null {
    const found = hoveredAt(state.doc.toString(), offset);
    const text = found ? state.sliceDoc(found.from, found.to) : '';
    const quantity = found && !found.onKey ? parseQuantity(text) : null;
    if (!found || !quantity || quantity.divisor !== '') {
        return null;
    }
    const name = [...found.path].reverse().find((key) => !/^\d+$/.test(key)) ?? '';
    return { from: found.from, text, name };
}

/// The number changed by some steps of its last digit.
export function stepped(text: string, steps: number): string {
    const old = parseQuantity(text);
    if (!old) {
        return text;
    }
    const decimals = /\.(\d*)/.exec(old.number)?.[1]?.length ?? 0;
    const exponent = Number(/[eE](.*)$/.exec(old.number)?.[1] ?? 0);
    const step = 10 ** (exponent - decimals) * old.scale;
    return writeLike(old, old.value + steps * step, step);
}

/// A drag of a number: it is typed outside of the history, and once as a step at the end.
function drag(start: MouseEvent, number: NumberInText): void {
    const file = activeFile.value;
    const typing = new DragTyping();
    const end = number.from + number.text.length;
    const move = (event: MouseEvent) => {
        const steps = Math.round((event.clientX - start.clientX) / kPixels);
        const text = stepped(number.text, steps * (event.shiftKey ? 10 : 1));
        if (!typing.isAlone) {
            live.end(false);  // the number may be elsewhere now
            return;
        }
        const edit = { from: number.from, to: end, insert: text };
        typing.show(typing.origin.map((one) =>
            one.file === file ? { ...one, text: applyEdits(one.text, [edit]) } : one));
    };
    const up = () => live.end(true);
    const press = (event: KeyboardEvent) => {
        if (event.key === 'Escape') {
            event.preventDefault();
            event.stopPropagation();
            live.end(false);
        }
    };
    const live: LiveDrag = {
        hasTyped: (one) => typing.hasTyped(one),
        stateBefore: (one) => typing.stateBefore(one),
        rebase: (one, change) => typing.rebase(one, change),
        end: (isKept) => {
            if (!stopDrag(live)) {
                return;
            }
            removeEventListener('mousemove', move);
            removeEventListener('mouseup', up);
            removeEventListener('keydown', press, true);
            document.body.classList.remove('scrubbing');
            const step = typing.finish();
            if (isKept) {
                typeStep(step, `Change ${number.name}`);
            }
        },
    };
    startDrag(live);
    document.body.classList.add('scrubbing');
    addEventListener('mousemove', move);
    addEventListener('mouseup', up);
    addEventListener('keydown', press, true);
}

/// Changes the number at the cursor; whether there is one.
function nudge(view: EditorView, steps: number): boolean {
    const number = view.state.readOnly ? null
        : numberAt(view.state, view.state.selection.main.head);
    if (!number) {
        return false;
    }
    const changes = { from: number.from, to: number.from + number.text.length,
        insert: stepped(number.text, steps) };
    typeStep([{ file: activeFile.value, changes }], `Change ${number.name}`);
    return true;
}

export const scrub: Extension = [
    EditorView.domEventHandlers({
        mousedown: (event, view) => {
            const at = event.altKey && event.button === 0 && !view.state.readOnly
                ? view.posAtCoords({ x: event.clientX, y: event.clientY }) : null;
            const number = at === null ? null : numberAt(view.state, at);
            if (!number) {
                return false;
            }
            drag(event, number);
            event.preventDefault();
            return true;
        },
        mousemove: (event, view) => {
            view.dom.classList.toggle('cm-alt', event.altKey);
            return false;
        },
    }),
    keymap.of([
        { key: 'Ctrl-ArrowUp', run: (view) => nudge(view, 1) },
        { key: 'Ctrl-ArrowDown', run: (view) => nudge(view, -1) },
        { key: 'Ctrl-Shift-ArrowUp', run: (view) => nudge(view, 10) },
        { key: 'Ctrl-Shift-ArrowDown', run: (view) => nudge(view, -10) },
    ]),
];
