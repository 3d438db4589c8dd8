/// Adding, duplicating, renaming and deleting things of the shot: each one step of undo.
import { insertEntry, insertItem, removeValue, sourceOf } from '../edit/edit';
import { namesOfSet } from '../edit/ball_names';
import { filmDuration } from '../motion/clock';
import type { KeyPath, ShotState } from '../protocol';
import { onCommand } from '../state/keys';
import { indexOfPart, kParts } from '../sequence/parts';
import { notice, selection, sequence, shot } from '../state/state';
import { kNoNames } from '../text/complete/candidates';
import { snippetsFor } from '../text/complete/snippets';
import { freeName } from './free_name';
import { atEnd, lengthOf, originalText } from './original_text';
import { isThing, thingOf } from './thing';

const kNewCamera = 3; // s
const kLists = new Set(['events', 'cameras', 'annotations']);

/// A place on the cloth where a ball fits, m.
export function freePlace(state: ShotState): [number, number] {
    const balls = state.objects.filter((object) => object.kind === 'ball');
    const radius = balls[0]?.radius ?? state.table?.ball_radius ?? 0.0286;
    const [length, width] = [(state.table?.length ?? 2) / 2, (state.table?.width ?? 1) / 2];
    for (let y = 0; y < width - 2 * radius; y += 0.1) {
        for (let x = 0; x < length - 2 * radius; x += 0.1) {
            for (const [px, py] of [[-x, -y], [x, -y], [-x, y], [x, y]] as const) {
                if (balls.every(({ position }) =>
                    Math.hypot(position[0] - px, position[1] - py) > 2.5 * radius)) {
                    return [Number(px.toFixed(2)) + 0, Number(py.toFixed(2)) + 0];
                }
            }
        }
    }
    return [0, 0];
}

function namesTaken(state: ShotState): string[] {
    const { balls, objects, materials, lights } = state.names;
    return [...balls, ...objects, ...materials, ...lights];
}

/// The first ball of the set that is not there yet.
function freeBall(state: ShotState, wanted: string): string {
    const taken = namesTaken(state);
    const radius = state.table?.ball_radius ?? 0.028575;
    return namesOfSet(radius).find((name) => !taken.includes(name)) ?? freeName(wanted, taken);
}

export interface Template {
    label: string;
    about: string;
    run(): void;
}

function done(result: { ok: boolean; message: string }, path: KeyPath): void {
    if (result.ok) {
        selection.value = path;
    } else if (result.message !== '') {
        notice.value = { kind: 'error', text: result.message };
    }
}

/// Adds an entry at the end of a list.
function addItem(section: string, state: ShotState, yaml: string, label: string): void {
    const known = section === 'cameras' ? state.cameras
        : section === 'annotations' ? state.annotations : state.events;
    const length = lengthOf(section, known.length);
    done(insertItem([section], length, yaml, label), [section, String(length)]);
}

/// A new camera films after the others, under a name of its own.
function newCamera(yaml: string, state: ShotState): string {
    const name = /^name: (.*)$/m.exec(yaml)?.[1] ?? 'camera';
    return atEnd(yaml, name, { numerator: kNewCamera, denominator: 1 }, state);
}

/// What can be added to a section of the shot.
export function templatesOf(section: string): Template[] {
    if (section === kParts.join('.')) {
        return partTemplates();
    }
    const state = shot.peek();
    if (!state) {
        return [];
    }
    return snippetsFor([section], state.names ?? kNoNames, filmDuration.peek()).map((snippet) => ({
        label: snippet.label, about: snippet.about,
        run: () => {
            const plain = snippet.yaml.replace(/\$\{([^}]*)\}/g, '$1');
            if (kLists.has(section)) {
                addItem(section, state, section === 'cameras' ? newCamera(plain, state) : plain,
                    `Add ${snippet.label}`);
                return;
            }
            const [, wanted = 'new', value = '{}'] = /^([^:]+): ([\s\S]*)$/.exec(plain) ?? [];
            const name = section === 'balls' ? freeBall(state, wanted)
                : freeName(wanted, namesTaken(state));
            const yaml = section === 'balls' ? `{at: [${freePlace(state).join(', ')}]}` : value;
            done(insertEntry([section], name, yaml, `Add ${snippet.label}`), [section, name]);
        },
    }));
}

/// The thing that the selection belongs to.
function chosenThing(): KeyPath | null {
    const path = selection.peek();
    return path && isThing(path) ? thingOf(path) : null;
}

/// Takes what is selected out of the text: a point of a ramp or of a path, or a whole thing.
export function deleteSelected(): void {
    const path = selection.peek();
    if (!path || !isThing(path)) {
        return;
    }
    const thing = thingOf(path);
    const isPoint = path.length > thing.length && /^\d+$/.test(path[path.length - 1] ?? '');
    const what = isPoint ? path : thing;
    if (!sourceOf(what)) {
        notice.value = { kind: 'info',
            text: `'${what.join('.')}' is not in the text: it comes from a rack or a preset.` };
        return;
    }
    const result = removeValue(what, `Delete ${what[what.length - 1]}`, true);
    if (result.ok) {
        selection.value = isPoint ? thing : null;
    }
}

/// Adds a part to a film of several shots before the one with that index.
function addPart(index: number, yaml: string, label: string): void {
    done(insertItem(kParts, index, yaml, label), [...kParts, String(index)]);
}

function duplicatePart(): void {
    const path = chosenThing();
    const text = path ? sourceOf(path)?.text : undefined;
    if (path && text !== undefined) {
        addPart(indexOfPart(path) + 1, text, 'Duplicate part');
    }
}

/// What can be added to a film of several shots: a card after the selected part, and its shot again.
function partTemplates(): Template[] {
    const parts = sequence.peek()?.parts ?? [];
    const chosen = indexOfPart(selection.peek());
    const at = chosen < 0 ? parts.length : chosen + 1;
    const files = [...new Set(parts.flatMap(({ kind, path }) => {
        const name = kind === 'shot' ? sourceOf([...path, 'shot'])?.text : undefined;
        return name === undefined ? [] : [name];
    }))];
    return [
        { label: 'title card', about: 'a text for three seconds',
            run: () => addPart(at, '{title: Title, for: 3 s, fade: 0.5 s}', 'Add title card') },
        ...files.map((name) => ({ label: `shot ${name}`, about: 'the shot once more',
            run: () => addPart(at, `{shot: ${name}}`, `Add shot ${name}`) })),
    ];
}

/// Adds a copy of the selected thing after it; a camera follows at the end of the film.
export function duplicateSelected(): void {
    if (sequence.peek()) {
        duplicatePart();
        return;
    }
    const state = shot.peek();
    const path = chosenThing();
    const [section = '', key = ''] = path ?? [];
    const text = path ? originalText(path) : null;
    if (!state || !path || text === null) {
        return;
    }
    if (kLists.has(section)) {
        addItem(section, state, text, `Duplicate ${section.replace(/s$/, '')}`);
        return;
    }
    const name = freeName(`${key}_2`, namesTaken(state));
    done(insertEntry([section], name, text, `Duplicate ${key}`), [section, name]);
}

/// Binds the commands of the selection. Returns a function that ends this.
export function bindSelectionCommands(): () => void {
    const endings = [onCommand('delete', deleteSelected), onCommand('duplicate', duplicateSelected)];
    return () => endings.forEach((end) => end());
}
