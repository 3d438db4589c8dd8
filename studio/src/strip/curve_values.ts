/// Speeds as people choose them, and steps that a pixel resolves.
import { roundStep } from './axis';

/// Speeds that a drag snaps to: standing still, real time and its usual fractions.
export const kUsualSpeeds: readonly number[] = [0, ...[1 / 64, 1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2]
    .flatMap((speed) => [speed, -speed])];

const kSnap = 3; // px

/// The usual speed within a few pixels, or the value rounded to what a pixel resolves.
export function roundSpeed(value: number, perPixel: number): number {
    const nearest = kUsualSpeeds.reduce((best, speed) =>
        Math.abs(speed - value) < Math.abs(best - value) ? speed : best);
    if (Math.abs(nearest - value) < kSnap * perPixel) {
        return nearest;
    }
    const step = roundStep(perPixel / 2);
    return Number((Math.round(value / step) * step).toPrecision(9));
}

/// A speed as YAML has it: "1/16" where that is exact, else with at most four digits.
export function speedAsText(speed: number): string {
    const inverse = 1 / Math.abs(speed);
    const whole = Math.round(inverse);
    if (Math.abs(speed) < 1 && Number.isFinite(inverse) && Math.abs(inverse - whole) < 1e-9 * whole) {
        return `${speed < 0 ? '-' : ''}1/${whole}`;
    }
    return String(Number(speed.toPrecision(4)));
}
