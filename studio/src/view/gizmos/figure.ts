/// What the gizmos draw, as plain data: pure functions make figures, src/view/gizmos/sketch.ts
/// draws them all together.
import type { Triple } from '../../protocol';

/// Colours of the gizmos, sRGB. The same in both themes: the scene behind them is the same.
export const kColours = {
    accent: 0x5aa9f7,
    aim: 0xf4f6f8,
    ghost: 0xf4f6f8,
    tangent: 0x67c7e8,
    rebound: 0xb9c4cf,
    wrong: 0xff5d63,
    handle: 0xffffff,
    x: 0xf0565b,
    y: 0x5bbf6a,
    z: 0x4c9bf5,
    strike: 0xf0c060,
    force: 0xf78c6c,
    velocity: 0x5cc08b,
    torque: 0xc792ea,
    pinned: 0x98a2ad,
    potted: 0x5cc08b,
    contact: 0xf0c060,
} as const;

export interface Line {
    from: Triple;
    to: Triple;
    colour: number;
    /// Thin and translucent.
    isFaint?: boolean;
}

export type DotShape = 'disc' | 'ring' | 'square' | 'diamond';

/// A mark of a size in CSS pixels, above everything.
export interface Dot {
    at: Triple;
    colour: number;
    size: number;
    shape: DotShape;
}

/// A translucent ball.
export interface GhostBall {
    at: Triple;
    radius: number;
    colour: number;
}

/// The head of an arrow, of a size in CSS pixels, with its tip at `at`.
export interface Tip {
    at: Triple;
    along: Triple;
    colour: number;
    size?: number;
}

export interface Label {
    at: Triple;
    text: string;
    tone?: 'plain' | 'wrong' | 'faint';
    isBelow?: boolean;
}

export interface Figure {
    lines?: Line[];
    dots?: Dot[];
    balls?: GhostBall[];
    tips?: Tip[];
    labels?: Label[];
}

/// All figures in one.
export function together(...figures: Figure[]): Figure {
    return {
        lines: figures.flatMap((one) => one.lines ?? []),
        dots: figures.flatMap((one) => one.dots ?? []),
        balls: figures.flatMap((one) => one.balls ?? []),
        tips: figures.flatMap((one) => one.tips ?? []),
        labels: figures.flatMap((one) => one.labels ?? []),
    };
}
