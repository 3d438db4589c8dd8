/// Thin lines at the columns of the keys above.
import { RangeSetBuilder } from '@codemirror/state';
import {
    Decoration, EditorView, ViewPlugin, type DecorationSet, type ViewUpdate,
} from '@codemirror/view';

const kMost = 12;  // levels
const kStep = 2;  // columns of a level

const lines = Array.from({ length: kMost + 1 }, (_, i) =>
    Decoration.line({ class: `cm-indent-${i}` }));

function decorations(view: EditorView): DecorationSet {
    const builder = new RangeSetBuilder<Decoration>();
    const { doc } = view.state;
    for (const { from, to } of view.visibleRanges) {
        let above = 0;
        for (let at = from; at <= to;) {
            const line = doc.lineAt(at);
            const isBlank = line.text.trim() === '';
            const indent = line.text.length - line.text.trimStart().length;
            const level = isBlank ? above : Math.min(kMost, Math.floor(indent / kStep));
            above = level;
            const decoration = lines[level];
            if (level > 0 && decoration) {
                builder.add(line.from, line.from, decoration);
            }
            at = line.to + 1;
        }
    }
    return builder.finish();
}

const plugin = ViewPlugin.define((view) => ({
    decorations: decorations(view),
    update(update: ViewUpdate) {
        if (update.docChanged || update.viewportChanged) {
            this.decorations = decorations(update.view);
        }
    },
}), { decorations: (one: { decorations: DecorationSet }) => one.decorations });

/// The guides of a level, as wide as the indent, after the line's padding of 6 pixels.
const look = EditorView.theme(Object.fromEntries(lines.slice(1).map((_, i) => [
    `.cm-indent-${i + 1}`,
    {
        backgroundImage: 'repeating-linear-gradient(to right, var(--line) 0 1px, transparent 1px 2ch)',
        backgroundSize: `${kStep * (i + 1)}ch 100%`, backgroundPosition: '6px 0',
        backgroundRepeat: 'no-repeat',
    },
])));

export const indentGuides = [plugin, look];
