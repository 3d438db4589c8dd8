/// What the menu of a place offers for the camera that is drawn in full.
import { applyChanges, insertItem, type Change } from '../../edit/edit';
import { cameraAxes } from '../../motion/camera';
import { dot, subtract } from '../../motion/vectors';
import type { Camera, KeyPath, PathShape, SceneObject, Triple } from '../../protocol';
import { sceneTime } from '../../state/state';
import { tracks } from '../../motion/clock';
import { easedPath } from '../camera_gizmos/eased_value';
import { focusChange, lensValue, type LensNow } from '../camera_gizmos/lens_handles';
import type { MenuItem } from './menu_state';

const kPrecision = 1e-3; // m

const written = (at: Triple) => `[${at.map((value) => Number(value.toFixed(3))).join(', ')}]`;

function change(label: string, changes: Change[], startsGroup = false): MenuItem {
    return { label, startsGroup, run: () => { applyChanges(changes, label, true); } };
}

/// Where an object is at the play head.
function placeNow(object: SceneObject): Triple {
    return tracks.peek().get(object.name)?.position(sceneTime.peek()) ?? object.position;
}

/// For an object: look at it, keep looking at it, focus on it.
export function objectItems(lens: LensNow, object: SceneObject): MenuItem[] {
    const { camera } = lens;
    const target = [...camera.path, 'target'];
    const focus = [...camera.path, 'focus'];
    const values = lensValue(lens, focus, (pose) => pose.focusDistance);
    return [
        change(`Aim “${camera.name}” at ${object.name}`,
            [{ path: target, value: placeNow(object), precision: kPrecision }], true),
        change(`Track ${object.name} with “${camera.name}”`,
            [{ path: target, value: { yaml: `{follow: ${object.name}}` } }]),
        change(`Let “${camera.name}” move with ${object.name}`, [{
            path: [...camera.path, 'position'],
            value: { yaml: `{follow: ${object.name}, offset: ${
                written(subtract(lens.pose.position, placeNow(object)))}}` },
        }]),
        change(`Focus “${camera.name}” on ${object.name}`,
            [{ path: easedPath(focus, values), value: object.name }]),
    ];
}

/// For a place on a surface: look at it, focus on it.
export function placeItems(lens: LensNow, at: Triple): MenuItem[] {
    const { camera, pose } = lens;
    const depth = -dot(subtract(at, pose.position), cameraAxes(pose).back);
    return [
        change(`Aim “${camera.name}” here`,
            [{ path: [...camera.path, 'target'], value: at, precision: kPrecision }], true),
        ...depth > 0.01 ? [change(`Focus “${camera.name}” here`,
            [focusChange(lens, depth, kPrecision)])] : [],
    ];
}

/// The piece of a curve, counted in its points, that is nearest to a place.
function pieceAt(points: readonly Triple[], at: Triple): number {
    let best = 0;
    let least = Infinity;
    points.slice(1).forEach((to, i) => {
        const from = points[i] ?? to;
        const way = subtract(to, from);
        const part = Math.min(1, Math.max(0, dot(subtract(at, from), way) / (dot(way, way) || 1)));
        const off = subtract(at, from).map((value, k) => value - part * (way[k] ?? 0)) as Triple;
        const distance = dot(off, off) + (part === 0 || part === 1 ? 1e-12 : 0);
        if (distance < least) {
            [best, least] = [i, distance];
        }
    });
    return best;
}

/// Adds a point to a camera's path: within its list, or after the point that it has.
export function addPoint(
    camera: Camera, part: 'position' | 'target', at: Triple, label: string,
): void {
    const shape: PathShape = camera[part];
    const list: KeyPath = [...camera.path, part, shape.kind];
    const isList = shape.points[0]?.path.length === list.length + 1;
    if (isList) {
        const places = shape.points.map((point) => point.position);
        const last = places.length - 1;
        const piece = places.length < 2 ? 0 : pieceAt(places, at);
        const isBeyond = places.length >= 2 && piece === last - 1
            && dot(subtract(at, places[last] ?? at),
                subtract(places[last] ?? at, places[last - 1] ?? at)) > 0;
        insertItem(list, isBeyond || places.length < 2 ? places.length : piece + 1,
            written(at), label, true);
        return;
    }
    const old = shape.points[0]?.position ?? at;
    applyChanges([{
        path: [...camera.path, part], value: { yaml: `{bezier: [${written(old)}, ${written(at)}]}` },
    }], label, true);
}

/// Whether points can be added to a path.
export function takesPoints(shape: PathShape): boolean {
    return shape.kind === 'bezier' || shape.kind === 'spline';
}

export function addItem(
    camera: Camera, part: 'position' | 'target', at: Triple,
): MenuItem {
    const label = part === 'position' ? `Add a point of “${camera.name}” here`
        : `Add a point of what “${camera.name}” looks at`;
    return {
        label, isDisabled: !takesPoints(camera[part]),
        run: () => addPoint(camera, part, at, label),
    };
}
