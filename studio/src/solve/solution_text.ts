/// Solutions in words.
import type { ShotSolution } from '../protocol';

/// "corner left back", as people read "corner_left_back".
export function pocketWords(pocket: string): string {
    return pocket.replaceAll('_', ' ');
}

/// "cue – one, one – back cushion, one in corner left back".
export function routeWords(route: string): string {
    return pocketWords(route.replaceAll(' - ', ' – '));
}

export function percent(chance: number): string {
    return `${Math.round(100 * chance)} %`;
}

/// "0.41°", with as many digits as tell something of small windows.
export function degrees(angle: number): string {
    const value = (angle * 180) / Math.PI;
    return `${value.toFixed(Math.abs(value) < 10 ? 2 : 1)}°`;
}

/// Of a strike that was found a moment ago the window and the chance are not computed yet.
export function isChanceKnown({ window, chance }: ShotSolution): boolean {
    return window > 0 || chance > 0;
}

/// "78 % ± 4, within 0.41°", or what it lacks.
export function chanceWords(one: ShotSolution): string {
    if (!one.is_solved) {
        return `misses the place by ${one.miss.toFixed(2)} m`;
    }
    const error = Math.round(100 * one.chance_error);
    return !isChanceKnown(one) ? 'chance …'
        : `${percent(one.chance)}${error > 0 ? ` ± ${error}` : ''}, within ${degrees(one.window)}`;
}

/// "2.8 m/s", "1.05 m/s of the ball".
export function speedWords({ speed, is_ball_speed }: ShotSolution): string {
    return `${Number(speed.toPrecision(3))} m/s${is_ball_speed ? ' of the ball' : ''}`;
}

/// Where the tip hits, as players say it: "tip 0.3 right, 0.2 low"; "centre".
export function tipWords([right, up]: readonly [number, number]): string {
    const part = (value: number, positive: string, negative: string) =>
        Math.abs(value) < 0.005 ? []
            : [`${Number(Math.abs(value).toFixed(2))} ${value > 0 ? positive : negative}`];
    const words = [...part(right, 'right', 'left'), ...part(up, 'high', 'low')];
    return words.length > 0 ? `tip ${words.join(', ')}` : 'centre of the ball';
}
