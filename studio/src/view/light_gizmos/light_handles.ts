/// The handles of a light: its place, where it shines, and its measures.
import { sourceOf, type Change } from '../../edit/edit';
import { add, dot, length, scale, subtract, unit } from '../../motion/vectors';
import type { SceneLight, Triple } from '../../protocol';
import { planeAxes } from '../gizmos/rays';
import type { Handle } from '../handles/handle';
import { coneLength, halfEdges, kLightColour, sunArrow } from './light_figure';

const kFacing = 0.3; // m, of the handle of a direction
const kSmallest = 1e-3; // m
const kDegree = Math.PI / 180;
const kAnglePrecision = 0.1 * kDegree;
const kShortest = 1e-3; // m, of a direction that is written
const kDirectionPrecision = 1e-3;

function handle(
    light: SceneLight, key: string, at: Triple, about: string,
    rest: Pick<Handle, 'shape' | 'way' | 'changes'>,
): Handle {
    const path = [...light.path, key];
    return {
        key: [...path, about].join('/'), path, at, label: `${light.name}: ${about}`,
        colour: kLightColour, size: rest.shape === 'square' ? 9 : 14, ...rest,
    };
}

/// Writes a direction; not a vanishing one.
function face(light: SceneLight, way: Triple): Change[] {
    return length(way) < kShortest ? []
        : [{ path: [...light.path, 'facing'], value: way, precision: kDirectionPrecision }];
}

function place(light: SceneLight): Handle {
    return handle(light, 'at', light.position, 'place', {
        shape: 'disc', way: { kind: 'free' },
        changes: (to, precision) => [{ path: [...light.path, 'at'], value: to, precision }],
    });
}

function direction(light: SceneLight, distance: number): Handle {
    return handle(light, 'facing', add(light.position, scale(distance, light.facing)), 'direction', {
        shape: 'diamond', way: { kind: 'free' },
        changes: (to) => face(light, subtract(to, light.position)),
    });
}

function sun(light: SceneLight): Handle {
    const { from, to } = sunArrow(light);
    return handle(light, 'facing', from, 'direction', {
        shape: 'diamond', way: { kind: 'free' },
        changes: (place) => face(light, unit(subtract(to, place))),
    });
}

function edge(light: SceneLight, axis: 0 | 1): Handle {
    const half = halfEdges(light)[axis];
    const along = unit(half);
    const key = sourceOf([...light.path, 'panel']) ? 'panel' : 'rectangle';
    return handle(light, key, add(light.position, half), axis === 0 ? 'width' : 'height', {
        shape: 'square', way: { kind: 'line', along },
        changes: (to, precision) => {
            const wanted = Math.max(kSmallest, 2 * dot(subtract(to, light.position), along));
            const value = light.size.map((old, i) => (i === axis ? wanted : old));
            return [{ path: [...light.path, key], value, precision }];
        },
    });
}

function radius(light: SceneLight): Handle {
    const along: Triple = [1, 0, 0];
    return handle(light, 'sphere', add(light.position, scale(light.size[0] ?? 0, along)), 'radius', {
        shape: 'square', way: { kind: 'line', along },
        changes: (to, precision) => [{
            path: [...light.path, 'sphere'], precision,
            value: Math.max(kSmallest, dot(subtract(to, light.position), along)),
        }],
    });
}

function angle(light: SceneLight, end: 0 | 1): Handle {
    const [side] = planeAxes(light.facing);
    const far = coneLength(light);
    const middle = add(light.position, scale(far, light.facing));
    const along = end === 0 ? scale(-1, side) : side;
    const at = add(middle, scale(far * Math.tan(Math.min(light.size[end] ?? 0, 1.4)), along));
    return handle(light, 'angle', at, end === 0 ? 'start of the falloff' : 'edge', {
        shape: 'square', way: { kind: 'line', along },
        changes: (to) => {
            const wanted = Math.atan2(Math.max(0, dot(subtract(to, middle), along)), far);
            const [inner = 0, outer = 0] = light.size;
            const isOne = sourceOf([...light.path, 'angle'])?.kind === 'scalar';
            const limited = end === 0 ? Math.min(wanted, outer)
                : Math.max(wanted, isOne ? kDegree : Math.max(inner, kDegree));
            const value = isOne ? limited : end === 0 ? [limited, outer] : [inner, limited];
            return [{ path: [...light.path, 'angle'], value, precision: kAnglePrecision }];
        },
    });
}

export function lightHandles(light: SceneLight): Handle[] {
    switch (light.kind) {
        case 'point': return [place(light)];
        case 'sphere': return [place(light), radius(light)];
        case 'rectangle':
            return [place(light), direction(light, kFacing), edge(light, 0), edge(light, 1)];
        case 'disk':
        case 'shade': return [place(light), direction(light, kFacing)];
        case 'spot': {
            const isOne = sourceOf([...light.path, 'angle'])?.kind === 'scalar';
            return [place(light), direction(light, coneLength(light)), angle(light, 1),
                ...isOne ? [] : [angle(light, 0)]];
        }
        case 'directional': return [sun(light)];
        default: return [];
    }
}
