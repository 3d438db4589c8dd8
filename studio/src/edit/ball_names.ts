/// The names of balls, as docs/reference.md has them: balls of these names have their set's colours.

const kNumbers = ['one', 'two', 'three', 'four', 'five', 'six', 'seven', 'eight', 'nine', 'ten',
    'eleven', 'twelve', 'thirteen', 'fourteen', 'fifteen'];
const kReds = kNumbers.map((_, i) => `red_${i + 1}`);
const kColoured = ['yellow', 'green', 'brown', 'blue', 'pink', 'black'];

/// The balls of a rack's set.
export function rackedBalls(set: unknown): readonly string[] {
    const counts: Record<string, number> = {
        nine_ball: 9, ten_ball: 10, eight_ball: 15, fifteen_ball: 15,
    };
    if (set === 'snooker') {
        return [...kReds, ...kColoured];
    }
    return set === 'carom' ? ['white', 'yellow', 'red']
        : kNumbers.slice(0, counts[String(set)] ?? 0);
}

/// The names of a set's balls, of which it is known by their radius in metres: a ball of pool has
/// 28.6 mm, of snooker 26.25, of carom 30.75.
export function namesOfSet(radius: number): readonly string[] {
    return radius > 0.0296 ? ['white', 'yellow', 'red']
        : radius < 0.0275 ? ['cue', ...kColoured, ...kReds] : ['cue', ...kNumbers];
}
