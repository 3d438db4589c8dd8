/// What the schema and the shot say about the key or value under the pointer.
import { hoverTooltip } from '@codemirror/view';
import { isMap, isScalar, isSeq, type Node, type Pair } from 'yaml';
import { parseQuantity } from '../edit/quantity';
import { itemEnd, itemStart, keyText, parseTree, rangeOf, scalarText } from '../edit/yaml_tree';
import type { KeyPath, ValuePlace } from '../protocol';
import { keyAt, typesAt } from '../schema/keys';
import { schema } from '../schema/schema';
import { typesText } from '../schema/type_text';
import { shot } from '../state/state';
import { activeFile, bufferOf, buffers } from './buffers';
import { fact, make, prose } from './complete/about';

export interface Hovered {
    path: KeyPath;
    from: number;
    to: number;
    /// The text of the scalar, or empty for keys of maps and lists.
    value: string;
    onKey: boolean;
}

/// The key or scalar at an offset; null between them.
export function hoveredAt(text: string, offset: number): Hovered | null {
    const path: KeyPath = [];
    let node = parseTree(text).document.contents as Node | null;
    while (isMap(node) || isSeq(node)) {
        const items = node.items as (Node | Pair)[];
        const index = items.findIndex((item) =>
            itemStart(item) <= offset && offset <= itemEnd(text, item));
        const item = items[index];
        if (item === undefined) {
            return null;
        }
        if ('key' in item) {
            path.push(keyText(item));
            const [from, to] = rangeOf(item.key as Node);
            const value = isScalar(item.value) ? scalarText(item.value) : '';
            if (offset <= to) {
                return { path, from, to, value, onKey: true };
            }
            node = item.value as Node | null;
        } else {
            path.push(String(index));
            node = item;
        }
    }
    if (!isScalar(node)) {
        return null;
    }
    const [from, to] = rangeOf(node);
    return from <= offset && offset <= to && from < to
        ? { path, from, to, value: scalarText(node), onKey: false } : null;
}

function placeOf(path: KeyPath): ValuePlace | undefined {
    const wanted = path.join('\n');
    return shot.value?.places.find((place) => place.path.join('\n') === wanted);
}

const kOrigins: Record<string, string> = {
    shot: 'the shot', include: '', config: '', set: 'an option of the command',
};

/// Where the value that counts stands, if that is another place than the one under the pointer.
function originText(path: KeyPath): string {
    const place = placeOf(path);
    if (!place) {
        return '';
    }
    const name = bufferOf(place.value.file)?.name;
    const file = name?.slice(name.lastIndexOf('/') + 1);
    const where = file ? `${file}:${place.value.line}` : '';
    const what = kOrigins[place.origin] ?? place.origin;
    return place.value.file === activeFile.value && place.origin !== 'set' ? '' : [what, where].filter((one) => one).join(', ');
}

/// Whether the value here is replaced by one of a file that counts more.
function isReplaced(path: KeyPath): boolean {
    const place = placeOf(path);
    return place !== undefined && place.value.file !== activeFile.value
        && activeFile.value !== buffers.value[0]?.file;
}

const kSiUnits: Record<string, string> = { deg: 'rad', mm: 'm', cm: 'm', ms: 's', 'km/h': 'm/s' };

/// "0.524 rad" for "30 deg": the value in SI units if it is written in others.
function inSi(value: string): string {
    const quantity = parseQuantity(value);
    const unit = kSiUnits[quantity?.unit.trim() ?? ''];
    return quantity && unit ? `${Number(quantity.value.toPrecision(5))} ${unit}` : '';
}

function describe(found: Hovered): HTMLElement | null {
    const all = schema.value;
    if (!all) {
        return null;
    }
    const keyPath = [...found.path];
    while (/^\d+$/.test(keyPath[keyPath.length - 1] ?? '')) {
        keyPath.pop();
    }
    const key = keyAt(all, keyPath);
    const types = typesAt(all, found.path);
    if (!key && types.length === 0) {
        return null;
    }
    const ranges = types.flatMap((type) => type.kind === 'number' ? [type.range] : []);
    const words = types.flatMap((type) =>
        type.kind === 'choice' || type.kind === 'text' ? type.words : []).join(', ');
    const map = types.find((type) => type.kind === 'map');
    const about = key?.about ?? (map?.kind === 'map' ? map.node.description ?? '' : '');
    const title = make('div', 'title', '',
        make('span', 'above', found.path.slice(0, -1).map((one) => `${one} › `).join('')),
        make('span', '', found.path[found.path.length - 1] ?? ''),
        make('span', 'kind', typesText(all, types)));
    return make('div', 'about hover-about', '', title, about === '' ? null : prose(about),
        fact('range', ranges[0] ?? ''), fact('one of', words), fact('default', key?.usual ?? ''),
        fact('value', inSi(found.value)),
        fact(isReplaced(found.path) ? 'replaced' : 'from', originText(found.path)));
}

/// The tooltip over keys and values.
export const hoverAbout = hoverTooltip((view, pos) => {
    const found = hoveredAt(view.state.doc.toString(), pos);
    const dom = found && describe(found);
    return found && dom && { pos: found.from, end: found.to, above: true, create: () => ({ dom }) };
}, { hoverTime: 350 });
