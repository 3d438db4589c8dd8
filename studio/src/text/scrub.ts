/// Numbers in the text change by a drag with Alt, and by Ctrl with the arrow keys: by one of their
/// last digit, ten with Shift.
import type { EditorState, Extension } from '@codemirror/state';
import { EditorView, keymap } from '@codemirror/view';
import { send } from '../connection/socket';
import { parseQuantity, writeLike } from '../edit/quantity';
import { dragging } from '../state/state';
import { activeFile, restore, snapshot, typeOutside, typeStep } from './buffers';
import { hoveredAt } from './hover';

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
    const before = snapshot();
    let shown = number.text;
    const show = (text: string) => {
        if (text !== shown) {
            typeOutside(file, { from: number.from, to: number.from + shown.length, insert: text });
            shown = text;
        }
    };
    const move = (event: MouseEvent) => {
        const steps = Math.round((event.clientX - start.clientX) / kPixels);
        show(stepped(number.text, steps * (event.shiftKey ? 10 : 1)));
    };
    const end = (isKept: boolean) => {
        const text = shown;
        removeEventListener('mousemove', move);
        removeEventListener('mouseup', up);
        removeEventListener('keydown', press, true);
        document.body.classList.remove('scrubbing');
        dragging.value = false;
        send('dragging', { on: false });
        restore(before);
        if (isKept && text !== number.text) {
            const changes = { from: number.from, to: number.from + number.text.length, insert: text };
            typeStep([{ file, changes }], `Change ${number.name}`);
        }
    };
    const up = () => end(true);
    const press = (event: KeyboardEvent) => {
        if (event.key === 'Escape') {
            event.preventDefault();
            event.stopPropagation();
            end(false);
        }
    };
    document.body.classList.add('scrubbing');
    dragging.value = true;
    send('dragging', { on: true });
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
