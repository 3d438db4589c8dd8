/// A small square before each colour; a click on it opens the browser's choice of colours.
import { RangeSetBuilder } from '@codemirror/state';
import {
    Decoration, EditorView, ViewPlugin, WidgetType, type DecorationSet, type ViewUpdate,
} from '@codemirror/view';
import { isMap, isScalar, isSeq, type Node, type YAMLSeq } from 'yaml';
import { writeNumber } from '../edit/quantity';
import { keyText, parseTree, rangeOf, scalarText } from '../edit/yaml_tree';
import { typesAt } from '../schema/keys';
import { schema } from '../schema/schema';
import { activeFile, typeStep } from './buffers';

interface Colour {
    from: number;
    to: number;
    /// "#rrggbb" as the screen shows it.
    shown: string;
    /// What a list is multiplied by after a choice; 0: the colour is written as "#rrggbb".
    scale: number;
}

const kHex = /^#[0-9a-fA-F]{6}$/;

/// Between linear light and the numbers of a screen, both from 0 to 1.
function toScreen(light: number): number {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
}

function toLight(number: number): number {
    return number <= 0.04045 ? number / 12.92 : ((number + 0.055) / 1.055) ** 2.4;
}

function hexOf(light: readonly number[]): string {
    return `#${light.map((one) => Math.round(255 * toScreen(Math.min(1, Math.max(0, one))))
        .toString(16).padStart(2, '0')).join('')}`;
}

/// Whether the schema has a colour at the path.
function isColour(path: string[]): boolean {
    return schema.value !== null && typesAt(schema.value, path)
        .some((type) => type.kind === 'text' && type.pattern.startsWith('^#'));
}

function listColour(node: YAMLSeq, path: string[]): Colour[] {
    const numbers = node.items.map((item) => isScalar(item) ? Number(scalarText(item)) : NaN);
    if (numbers.length !== 3 || !node.flow || !numbers.every(Number.isFinite) || !isColour(path)) {
        return [];
    }
    const [from, to] = rangeOf(node);
    const scale = Math.max(1, ...numbers);
    return [{ from, to, scale, shown: hexOf(numbers.map((one) => one / scale)) }];
}

/// The colours below a node.
function coloursOf(node: Node | null, path: string[]): Colour[] {
    if (isMap(node)) {
        return node.items.flatMap((pair) =>
            coloursOf(pair.value as Node | null, [...path, keyText(pair)]));
    }
    if (isSeq(node)) {
        const own = listColour(node, path);
        return own.length > 0 ? own : node.items.flatMap((item, i) =>
            coloursOf(item as Node, [...path, String(i)]));
    }
    if (isScalar(node) && kHex.test(scalarText(node))) {
        const [from, to] = rangeOf(node);
        return [{ from, to, scale: 0, shown: scalarText(node) }];
    }
    return [];
}

/// The colours of the whole text in their order; none while it is not well formed.
function coloursIn(view: EditorView): Colour[] {
    const tree = parseTree(view.state.doc.toString());
    const all = tree.mistake === '' ? coloursOf(tree.document.contents as Node | null, []) : [];
    return all.sort((a, b) => a.from - b.from);
}

/// Writes a colour over the one that begins at an offset of the text.
function write(view: EditorView, offset: number, chosen: string): void {
    const colour = coloursIn(view).find(({ from }) => from === offset);
    if (!colour) {
        return;
    }
    const light = [1, 3, 5].map((at) => toLight(parseInt(chosen.slice(at, at + 2), 16) / 255));
    const insert = colour.scale === 0
        ? view.state.sliceDoc(colour.from, colour.to).replace(/#[0-9a-fA-F]{6}/, chosen)
        : `[${light.map((one) => writeNumber(one * colour.scale, 0.001)).join(', ')}]`;
    typeStep([{ file: activeFile.value, changes: { from: colour.from, to: colour.to, insert } }],
        'Change colour');
}

class Swatch extends WidgetType {
    constructor(private readonly shown: string) {
        super();
    }

    override eq(other: Swatch): boolean {
        return other.shown === this.shown;
    }

    override toDOM(view: EditorView): HTMLElement {
        const input = document.createElement('input');
        input.type = 'color';
        input.className = 'cm-swatch';
        input.value = this.shown;
        input.disabled = view.state.readOnly;
        input.tabIndex = -1;
        input.setAttribute('aria-label', `Colour ${this.shown}`);
        input.addEventListener('change', () => write(view, view.posAtDOM(input), input.value));
        return input;
    }

    override ignoreEvent(): boolean {
        return true;
    }
}

function decorations(view: EditorView): DecorationSet {
    const builder = new RangeSetBuilder<Decoration>();
    for (const { from, shown } of coloursIn(view)) {
        builder.add(from, from, Decoration.widget({ widget: new Swatch(shown), side: -1 }));
    }
    return builder.finish();
}

const plugin = ViewPlugin.define((view) => ({
    decorations: decorations(view),
    update(update: ViewUpdate) {
        if (update.docChanged) {
            this.decorations = decorations(update.view);
        }
    },
}), { decorations: (one: { decorations: DecorationSet }) => one.decorations });

const look = EditorView.theme({
    '.cm-swatch': {
        appearance: 'none', width: '11px', height: '11px', margin: '0 5px 0 1px', padding: '0',
        border: '1px solid var(--line-strong)', borderRadius: '3px', verticalAlign: '-1px',
        background: 'none', cursor: 'pointer', overflow: 'hidden',
    },
    '.cm-swatch:disabled': { cursor: 'default' },
    '.cm-swatch::-webkit-color-swatch-wrapper': { padding: '0' },
    '.cm-swatch::-webkit-color-swatch': { border: 'none' },
    '.cm-swatch::-moz-color-swatch': { border: 'none' },
});

export const swatches = [plugin, look];
