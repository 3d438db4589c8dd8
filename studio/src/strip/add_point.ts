/// Points that a double click adds to the curves.
import { applyChanges, sourceOf } from '../edit/edit';
import { shot } from '../state/state';
import { timeAt } from './axis';
import { addLensKey } from './handles/lens_handles';
import { addSpeedPoint } from './handles/speed_handles';
import { isIn, type Layout } from './layout';
import { curveCamera, curveName } from './strip_state';

/// The key whose one value can become one at the start and one at the end.
const kKeys = { fov: ['focal_length', 'fov'], focus: ['focus'], aperture: ['f_number', 'aperture'] };

/// In the row of curves: a point of the speed ramp, a key of a value that is given by keys, or two
/// ends for a value that does not change.
export function addPointAt(layout: Layout, { x, y }: { x: number; y: number }): void {
    const state = shot.peek();
    const camera = curveCamera.peek();
    const time = timeAt(layout.film, x);
    if (!state || !camera || !isIn(layout.curve, y) || time < camera.video_start
        || time > camera.video_end) {
        return;
    }
    const name = curveName.peek();
    if (name === 'speed') {
        addSpeedPoint(state, camera, time);
        return;
    }
    const key = kKeys[name].find((one) => sourceOf([...camera.path, one]));
    const source = key ? sourceOf([...camera.path, key]) : null;
    if (key && addLensKey(state, camera, key, time)) {
        return;
    }
    if (key && source?.kind === 'scalar') {
        applyChanges([{ path: [...camera.path, key],
            value: { yaml: `[${source.text}, ${source.text}]` } }], `Let ${key} change over time`,
        true);
    }
}
