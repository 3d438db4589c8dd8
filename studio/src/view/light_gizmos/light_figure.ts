/// Lights as lines: where they are, where they shine, and how large they are.
import { add, cross, rotate, scale, unit } from '../../motion/vectors';
import type { SceneLight, Triple } from '../../protocol';
import type { Figure, Line } from '../gizmos/figure';
import { planeAxes } from '../gizmos/rays';

export const kLightColour = 0xffd97a;
const kCirclePieces = 40;
const kNormal = 0.3; // m, of the arrow of a flat light
const kCross = 0.05; // m, of the mark of a point
const kLongestCone = 3; // m
const kSun = 1.1; // m, of the arrows of parallel light
const kSunHeight = 0.25; // m, of their tips above the cloth

function circle(centre: Triple, x: Triple, y: Triple, colour: number, isFaint: boolean): Line[] {
    const at = (i: number): Triple => {
        const angle = (2 * Math.PI * i) / kCirclePieces;
        return add(centre, add(scale(Math.cos(angle), x), scale(Math.sin(angle), y)));
    };
    return Array.from({ length: kCirclePieces }, (_, i) =>
        ({ from: at(i), to: at(i + 1), colour, isFaint }));
}

function arrow(from: Triple, to: Triple, isFaint: boolean): Figure {
    const along = unit([to[0] - from[0], to[1] - from[1], to[2] - from[2]]);
    return {
        lines: [{ from, to, colour: kLightColour, isFaint }],
        tips: isFaint ? [] : [{ at: to, along, colour: kLightColour }],
    };
}

/// The length of a spot's drawn cone: to the cloth, or a metre.
export function coneLength({ position, facing }: SceneLight): number {
    const down = facing[2] < -0.05 && position[2] > 0 ? position[2] / -facing[2] : 1;
    return Math.min(down, kLongestCone);
}

/// The ends of the arrow that stands for parallel light.
export function sunArrow({ facing }: SceneLight): { from: Triple; to: Triple } {
    const to: Triple = [0, 0, kSunHeight];
    return { from: add(to, scale(-kSun, unit(facing))), to };
}

/// Half the edges of a rectangle.
export function halfEdges({ orientation, size }: SceneLight): [Triple, Triple] {
    return [
        rotate(orientation, [(size[0] ?? 0) / 2, 0, 0]),
        rotate(orientation, [0, (size[1] ?? 0) / 2, 0]),
    ];
}

function rectangle(light: SceneLight, isFaint: boolean): Figure {
    const [u, v] = halfEdges(light);
    const corner = (x: number, y: number) => add(light.position, add(scale(x, u), scale(y, v)));
    const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
    const pointer = arrow(light.position, add(light.position, scale(kNormal, light.facing)), isFaint);
    return {
        ...pointer,
        lines: [...pointer.lines ?? [], ...corners.map((from, i): Line =>
            ({ from, to: corners[(i + 1) % 4] ?? from, colour: kLightColour, isFaint }))],
    };
}

/// A disk, or the opening of a shade.
function disk(light: SceneLight, isFaint: boolean): Figure {
    const radius = light.size[0] ?? 0;
    const [x, y] = planeAxes(light.facing);
    const pointer = arrow(light.position, add(light.position, scale(kNormal, light.facing)), isFaint);
    return {
        ...pointer,
        lines: [...pointer.lines ?? [],
            ...circle(light.position, scale(radius, x), scale(radius, y), kLightColour, isFaint)],
    };
}

function spot(light: SceneLight, isFaint: boolean): Figure {
    const [x, y] = planeAxes(light.facing);
    const length = coneLength(light);
    const end = add(light.position, scale(length, light.facing));
    const [inner = 0, outer = 0] = light.size;
    const radius = (angle: number) => length * Math.tan(Math.min(angle, 1.4));
    const rim = radius(outer);
    const sides = [x, scale(-1, x), y, scale(-1, y)].map((side): Line =>
        ({ from: light.position, to: add(end, scale(rim, side)), colour: kLightColour, isFaint }));
    return {
        lines: [
            ...sides, ...circle(end, scale(rim, x), scale(rim, y), kLightColour, isFaint),
            ...circle(end, scale(radius(inner), x), scale(radius(inner), y), kLightColour, true),
            { from: light.position, to: end, colour: kLightColour, isFaint: true },
        ],
    };
}

function directional(light: SceneLight, isFaint: boolean): Figure {
    const { from, to } = sunArrow(light);
    const [side] = planeAxes(light.facing);
    const other = unit(cross(side, light.facing));
    const beside = [[0, 0], [0.12, 0], [-0.12, 0], [0, 0.12], [0, -0.12]].map(([x = 0, y = 0]) =>
        add(scale(x, side), scale(y, other)));
    const arrows = beside.map((by, i) => arrow(add(from, by), add(to, by), isFaint || i > 0));
    return {
        lines: arrows.flatMap((one) => one.lines ?? []),
        tips: arrows.slice(0, 1).flatMap((one) => one.tips ?? []),
    };
}

function ball(light: SceneLight, isFaint: boolean): Figure {
    const radius = light.size[0] ?? 0;
    const [x, y, z]: [Triple, Triple, Triple] = [[radius, 0, 0], [0, radius, 0], [0, 0, radius]];
    return {
        lines: [[x, y], [y, z], [z, x]].flatMap(([a = x, b = y]) =>
            circle(light.position, a, b, kLightColour, isFaint)),
    };
}

function point({ position }: SceneLight, isFaint: boolean): Figure {
    return {
        lines: [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0.6, 0.5], [-0.6, 0.6, 0.5]].map((way): Line => ({
            from: add(position, scale(-kCross, way as Triple)),
            to: add(position, scale(kCross, way as Triple)), colour: kLightColour, isFaint,
        })),
    };
}

const kFigures: Record<string, (light: SceneLight, isFaint: boolean) => Figure> = {
    rectangle, disk, shade: disk, spot, directional, sphere: ball, point,
};

/// Where a click selects the light; null of an environment.
export function placeOf(light: SceneLight): Triple | null {
    return light.kind === 'environment' ? null
        : light.kind === 'directional' ? sunArrow(light).from : light.position;
}

export function lightFigure(light: SceneLight, isSelected: boolean): Figure {
    const figure = kFigures[light.kind]?.(light, !isSelected) ?? {};
    const at = placeOf(light);
    return at ? {
        ...figure,
        dots: isSelected ? [] : [{ at, colour: kLightColour, size: 9, shape: 'disc' }],
    } : figure;
}
