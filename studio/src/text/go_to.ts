/// Leads from a name to where it is defined, and from an include to its file: by Ctrl with a click,
/// and by F12.
import { EditorView, keymap } from '@codemirror/view';
import { currentFiles } from '../edit/current_files';
import { includedFile } from '../edit/layers';
import { typesAt } from '../schema/keys';
import { schema } from '../schema/schema';
import { activeFile } from './buffers';
import { hoveredAt } from './hover';
import { showRange } from './show';
import { placeOf } from './show_path';

const kSections = ['balls', 'objects', 'materials', 'lights'];

/// Shows the entry of that name; whether there is one.
function showEntry(name: string): boolean {
    const place = kSections.map((section) => placeOf([section, name])).find((one) => one !== null);
    if (place) {
        showRange(place);
    }
    return place !== undefined;
}

/// Goes to what the word at an offset means; whether it means something.
export function goTo(view: EditorView, offset: number): boolean {
    const found = hoveredAt(view.state.doc.toString(), offset);
    const all = schema.value;
    if (!found || found.onKey || !all) {
        return false;
    }
    const files = currentFiles();
    const own = files.find(({ file }) => file === activeFile.value);
    if (found.path.includes('include') && own) {
        const target = includedFile(files, own, found.value);
        if (target) {
            activeFile.value = target.file;
        }
        return target !== null;
    }
    const isName = typesAt(all, found.path).some((type) => type.kind === 'name');
    return isName && showEntry(found.value);
}

export const goToMeaning = [
    EditorView.domEventHandlers({
        mousedown: (event, view) => {
            const at = (event.ctrlKey || event.metaKey) && event.button === 0
                ? view.posAtCoords({ x: event.clientX, y: event.clientY }) : null;
            if (at === null || !goTo(view, at)) {
                return false;
            }
            event.preventDefault();
            return true;
        },
    }),
    keymap.of([{ key: 'F12', run: (view) => goTo(view, view.state.selection.main.head) }]),
];
