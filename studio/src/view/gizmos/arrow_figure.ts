/// Impulses, forces, torques and velocities as arrows.
import type { KeyPath, Triple, Turn } from '../../protocol';
import { add, length, rotate, scale } from '../../motion/vectors';
import { kColours, type Figure } from './figure';

export type ArrowKind = 'impulse' | 'force' | 'torque' | 'velocity';

export interface Arrow {
    /// Of the vector in the shot.
    path: KeyPath;
    kind: ArrowKind;
    /// Where it acts, at its time.
    base: Triple;
    /// As the text has it, in the object's axes if `turn` is not null.
    vector: Triple;
    turn: Turn | null;
    /// How many numbers the text has.
    count: number;
    isChosen: boolean;
}

const kUsual = 0.35; // m, of the longest arrow of a kind when it is first shown
const kShortest = 0.07; // m; else the scale is chosen anew
const kLongest = 1.3;

export const kUnits: Readonly<Record<ArrowKind, string>> = {
    impulse: 'N s', force: 'N', torque: 'N m', velocity: 'm/s',
};

const kArrowColours: Readonly<Record<ArrowKind, number>> = {
    impulse: kColours.force, force: kColours.force, torque: kColours.torque,
    velocity: kColours.velocity,
};

/// How long the arrow of a unit is, m, by kind. A scale is kept as long as it suits.
export function arrowScales(
    arrows: readonly Arrow[], before: ReadonlyMap<ArrowKind, number>,
): Map<ArrowKind, number> {
    const scales = new Map(before);
    for (const kind of new Set(arrows.map((one) => one.kind))) {
        const largest = Math.max(...arrows.filter((one) => one.kind === kind)
            .map(({ vector }) => length(vector)));
        const old = scales.get(kind);
        const drawn = largest * (old ?? 0);
        if (largest > 0 && (drawn < kShortest || drawn > kLongest)) {
            scales.set(kind, kUsual / largest);
        }
    }
    return scales;
}

/// The vector in the world.
export function worldVector({ vector, turn }: Arrow): Triple {
    return turn ? rotate(turn, vector) : vector;
}

/// The end of an arrow.
export function arrowTip(arrow: Arrow, unit: number): Triple {
    return add(arrow.base, scale(unit, worldVector(arrow)));
}

export function arrowFigure(
    arrows: readonly Arrow[], scales: ReadonlyMap<ArrowKind, number>,
): Figure {
    const shown = arrows.filter(({ vector }) => length(vector) > 0);
    const tipOf = (arrow: Arrow) => arrowTip(arrow, scales.get(arrow.kind) ?? 1);
    return {
        lines: shown.map((arrow) => ({
            from: arrow.base, to: tipOf(arrow), colour: kArrowColours[arrow.kind],
            isFaint: !arrow.isChosen,
        })),
        tips: shown.map((arrow) => ({
            at: tipOf(arrow), along: worldVector(arrow), colour: kArrowColours[arrow.kind],
            size: arrow.isChosen ? 16 : 11,
        })),
        labels: shown.filter(({ isChosen }) => isChosen).map((arrow) => ({
            at: tipOf(arrow),
            text: `${Number(length(arrow.vector).toPrecision(3))} ${kUnits[arrow.kind]}`,
        })),
    };
}
