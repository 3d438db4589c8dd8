import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BufferGeometry, Float32BufferAttribute } from 'three';
import { ringsAround } from '../../src/view/far_plane';

/// A plane as the server's file has it.
function plane(uv: number[]): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(
        [-20, 0, 20, 20, 0, 20, 20, 0, -20, -20, 0, -20], 3));
    geometry.setAttribute('uv', new Float32BufferAttribute(uv, 2));
    return geometry;
}

test('the rings around a plane continue the coordinates of its textures', () => {
    // u = 3 z + 1, v = 2 x
    const far = ringsAround(plane([61, -40, 61, 40, -59, 40, -59, -40]));
    const points = far.getAttribute('position');
    const uv = far.getAttribute('uv');
    assert.equal(uv.count, points.count);
    for (let i = 0; i < points.count; ++i) {
        assert.ok(Math.abs(uv.getX(i) - (3 * points.getZ(i) + 1)) < 0.01);
        assert.ok(Math.abs(uv.getY(i) - 2 * points.getX(i)) < 0.01);
    }
});

test('a plane without textures has none around it', () => {
    const bare = plane([]);
    bare.deleteAttribute('uv');
    assert.equal(ringsAround(bare).getAttribute('uv'), undefined);
});
