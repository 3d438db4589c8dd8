// Where the numbers on the balls are: as render/texture/ball_paint.cpp paints them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { figurePatches } from '../../src/view/ball_figures';

test('FigurePatches_OfBothEnds_LieOnTheSphereAndCanBeRead', () => {
    const geometry = figurePatches();
    const [places, uvs] = [geometry.getAttribute('position'), geometry.getAttribute('uv')];
    let [front, back] = [0, 0];
    for (let i = 0; i < places.count; ++i) {
        // The file's axes: the ball's (x, y, z) is (x, z, -y) there.
        const [x, y, z] = [places.getX(i), -places.getZ(i), places.getY(i)];
        assert.ok(Math.abs(Math.hypot(x, y, z) - 1) < 1e-6, 'on the unit sphere');
        // Seen from +x the right-hand side is +y and z is up; on the other side the figure stands on its head.
        const up = x >= 0 ? z : -z;
        assert.ok(Math.abs(uvs.getX(i) - (0.5 + y / 0.77)) < 1e-6, 'to the right');
        assert.ok(Math.abs(uvs.getY(i) - (0.5 + up / 0.77)) < 1e-6, 'up');
        [front, back] = x >= 0 ? [front + 1, back] : [front, back + 1];
    }
    assert.equal(front, back);
    // Their triangles face outwards.
    const index = geometry.getIndex();
    assert.ok(index);
    const corner = (at: number) => new Vector3().fromBufferAttribute(places, index.getX(at));
    for (let i = 0; i < index.count; i += 3) {
        const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
        const normal = b.clone().sub(a).cross(c.sub(a));
        assert.ok(normal.dot(a) > 0, 'outwards');
    }
});
