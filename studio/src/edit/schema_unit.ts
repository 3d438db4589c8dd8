/// The unit that a new number needs: angles and some others are refused without one.

/// Keys of angles, whose numbers other than 0 need a unit.
const kAngles = new Set(['direction', 'elevation', 'fov', 'roll', 'rotate', 'angle', 'angles',
    'shutter', 'tilt']);
/// Lengths of lenses, which need one, too.
const kLenses = new Set(['aperture', 'focal_length', 'sensor']);
const kDensities = new Set(['density']);

/// The unit for numbers at a path, or empty if plain numbers will do.
export function unitFor(path: readonly string[]): string {
    const key = [...path].reverse().find((one) => !/^\d+$/.test(one) && one !== 'from' && one !== 'to')
        ?? '';
    if (kAngles.has(key)) {
        return 'deg';
    }
    if (kLenses.has(key)) {
        return 'mm';
    }
    return kDensities.has(key) ? 'kg/m^3' : key === 'spin' ? 'rad/s' : '';
}
