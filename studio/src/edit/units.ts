/// Units as carom reads them: pipeline/config/units.cpp.

const kDegree = Math.PI / 180;

/// The value of each unit in SI units.
const kUnits: Readonly<Record<string, number>> = {
    m: 1, km: 1000, cm: 0.01, mm: 0.001, um: 1e-6, in: 0.0254, ft: 0.3048, yd: 0.9144,
    kg: 1, g: 0.001, mg: 1e-6, lb: 0.45359237, oz: 0.028349523125,
    s: 1, ms: 0.001, us: 1e-6, min: 60, h: 3600,
    rad: 1, deg: kDegree, turn: 360 * kDegree, rpm: Math.PI / 30,
    mph: 0.44704,
    N: 1, mN: 0.001, kN: 1000,
    Hz: 1, kHz: 1000, fps: 1,
    Pa: 1, kPa: 1e3, MPa: 1e6, GPa: 1e9,
    dB: 1, LUFS: 1, // logarithms, which have no SI unit
};

const kNamedUnit = /^\s*([A-Za-z]+)(\^?(-?)([1-9]))?/;
const kOperator = /^\s*([/*])/;

/// The value in SI units of a product of units such as "km/h", "N m" or "m/s^2"; 1 for an empty
/// text; null if it is none.
export function unitValue(text: string): number | null {
    let rest = text.trim();
    let value = 1;
    let isDivided = false;
    let needsUnit = false;
    let isFirst = true;
    while (rest !== '') {
        const operator = kOperator.exec(rest);
        if (operator) {
            if (isFirst || needsUnit) {
                return null;
            }
            isDivided = operator[1] === '/';
            needsUnit = true;
            rest = rest.slice(operator[0].length);
            continue;
        }
        const unit = kNamedUnit.exec(rest);
        const one = unit ? kUnits[unit[1] ?? ''] : undefined;
        if (!unit || one === undefined) {
            return null;
        }
        const power = Number(unit[4] ?? 1) * (unit[3] === '-' ? -1 : 1);
        value *= one ** (isDivided ? -power : power);
        isDivided = false;
        needsUnit = false;
        isFirst = false;
        rest = rest.slice(unit[0].length).trimStart();
    }
    return needsUnit ? null : value;
}
