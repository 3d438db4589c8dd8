/// A thing's text for its copy.
import { sourceOf, type Value } from '../edit/edit';
import { planRemove, planSet } from '../edit/plan';
import { applyEdits } from '../edit/text_edit';
import type { Camera, KeyPath, SceneObject, ShotState } from '../protocol';
import { shot } from '../state/state';
import { fractionOf, minus, sum, timeText, type Fraction } from '../strip/film_time';
import { parseValue, valueAt } from '../view/gizmos/shot_values';
import type { Parsed } from '../view/gizmos/measures';
import { freeName } from './free_name';

/// Text in YAML of its own, to be edited by the paths within it.
function editable(yaml: string) {
    let text = yaml;
    const files = () => [{ file: 'copy', name: 'the copy', text, writable: true }];
    const copy = {
        text: () => text,
        set: (path: KeyPath, value: Value) => {
            text = applyEdits(text, planSet(files(), path, value, { unit: '', precision: 1e-4 }).edits);
            return copy;
        },
        remove: (key: string) => {
            if (hasKey(text, key)) {
                text = applyEdits(text, planRemove(files(), [key]).edits);
            }
            return copy;
        },
    };
    return copy;
}

function hasKey(yaml: string, key: string): boolean {
    const value = parseValue(yaml);
    return typeof value === 'object' && !Array.isArray(value) && key in value;
}

/// The cameras as the text has them, which may be newer than the server's answer.
function camerasInText(): Record<string, unknown>[] {
    const list = valueAt(['cameras']);
    return Array.isArray(list)
        ? list.filter((one): one is Record<string, Parsed> => typeof one === 'object' && !Array.isArray(one))
        : [];
}

/// How many entries a list of the shot has in the text.
export function lengthOf(section: string, usual: number): number {
    const list = valueAt([section]);
    return Array.isArray(list) ? list.length : usual;
}

/// When the last camera ends.
function filmEnd(state: ShotState): Fraction {
    const written = camerasInText().map(({ video }) => Array.isArray(video) ? video[1] as unknown : null);
    const ends = written.length > 0 && written.every((end) => typeof end === 'number')
        ? written as number[] : state.cameras.map((one) => one.video_end);
    return fractionOf(Math.max(0, ...ends));
}

/// Puts a camera's text at the end of the film, with a name that no other camera has.
export function atEnd(yaml: string, name: string, length: Fraction, state: ShotState): string {
    const start = filmEnd(state);
    const taken = [...state.cameras.map((one) => one.name),
        ...camerasInText().map((one) => String(one['name'] ?? ''))];
    const video = [start, sum(start, length)].map((time) => timeText(time, null)).join(', ');
    return editable(yaml).set(['name'], freeName(name, taken))
        .set(['video'], { yaml: `[${video}]` }).text();
}

/// A camera's copy follows at the end of the film, its ramp with it.
export function copyOfCamera(yaml: string, camera: Camera, state: ShotState): string {
    const from = fractionOf(camera.video_start);
    const text = editable(yaml).remove('fade').text();
    const shift = minus(filmEnd(state), from);
    const copy = editable(atEnd(text, camera.name, minus(fractionOf(camera.video_end), from), state));
    for (const [i, { video_time }] of camera.speeds.entries()) {
        copy.set(['scene', 'speeds', String(i), '0'],
            { yaml: timeText(sum(fractionOf(video_time), shift), null) });
    }
    return copy.text();
}

/// A ball's copy lies beside it, as high.
export function copyOfBall(yaml: string, ball: SceneObject): string {
    const at = parseValue(yaml);
    const place = typeof at === 'object' && !Array.isArray(at) ? at['at'] : undefined;
    const [x, y] = [Number((ball.position[0] + 2.5 * ball.radius).toFixed(3)), ball.position[1]];
    if (Array.isArray(place) && place.length >= 2) {
        return editable(yaml).set(['at', '0'], x).set(['at', '1'], y).text();
    }
    return editable(yaml).remove('touching').set(['at'], [x, y]).text();
}

/// The value at a path on one line, for a copy. Null if the text does not have it.
export function originalText(path: KeyPath): string | null {
    const text = sourceOf(path)?.text;
    const state = shot.peek();
    if (!text || !state) {
        return null;
    }
    const key = path.join('/');
    const camera = state.cameras.find((one) => one.path.join('/') === key);
    if (camera) {
        return copyOfCamera(text, camera, state);
    }
    const ball = state.objects.find((one) => one.kind === 'ball' && one.path.join('/') === key);
    return ball ? copyOfBall(text, ball) : text;
}
