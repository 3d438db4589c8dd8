import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fovOfView, letterbox } from '../../src/view/letterbox';

test('Letterbox_OfAWideView_HasBarsAtBothSidesAndTheFilmsLens', () => {
    const box = letterbox({ width: 1000, height: 400 }, 2);
    assert.deepEqual(box, { left: 100, top: 0, width: 800, height: 400 });
    assert.ok(Math.abs(fovOfView(0.7, 400, box) - 0.7) < 1e-12);
});

test('Letterbox_OfANarrowView_HasBarsAboveAndBelowAndSeesMore', () => {
    const box = letterbox({ width: 400, height: 500 }, 2);
    assert.deepEqual(box, { left: 0, top: 150, width: 400, height: 200 });
    const fov = fovOfView(0.7, 500, box);
    assert.ok(Math.abs(Math.tan(fov / 2) / Math.tan(0.35) - 2.5) < 1e-12);
});
