/// Marks of a size in pixels, all in one draw call.
import {
    BufferGeometry, Color, Float32BufferAttribute, Points, ShaderMaterial,
} from 'three';
import type { Dot, DotShape } from './figure';

const kShapes: readonly DotShape[] = ['disc', 'ring', 'square', 'diamond'];

const kVertex = `
attribute vec3 tint;
attribute float size;
attribute float shape;
uniform float ratio;
varying vec3 vTint;
varying float vShape;
varying float vSize;
void main() {
    vTint = tint;
    vShape = shape;
    vSize = size * ratio;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_PointSize = vSize;
}`;

// A dark rim lets marks stand out from bright and from dark surfaces.
const kFragment = `
varying vec3 vTint;
varying float vShape;
varying float vSize;
void main() {
    vec2 p = abs(2.0 * gl_PointCoord - 1.0);
    float far = vShape < 1.5 ? length(p) : vShape < 2.5 ? max(p.x, p.y) * 1.15 : p.x + p.y;
    float pixel = 2.0 / vSize;
    bool isRing = vShape > 0.5 && vShape < 1.5;
    float rim = 1.0 - (isRing ? 2.0 : 3.0) * pixel;
    float alpha = clamp((1.0 - far) / pixel, 0.0, 1.0);
    vec3 colour = mix(vTint, vec3(0.02), clamp((far - rim) / pixel, 0.0, 1.0) * 0.85);
    if (isRing) {
        float inner = clamp((far - 1.0 + 4.5 * pixel) / pixel, 0.0, 1.0);
        alpha *= 0.15 + 0.85 * inner;
    }
    if (alpha < 0.02) discard;
    gl_FragColor = vec4(colour, alpha);
    #include <colorspace_fragment>
}`;

export class DotCloud {
    readonly points: Points<BufferGeometry, ShaderMaterial>;

    constructor() {
        this.points = new Points(new BufferGeometry(), new ShaderMaterial({
            vertexShader: kVertex, fragmentShader: kFragment, transparent: true, depthTest: false,
            uniforms: { ratio: { value: 1 } },
        }));
        this.points.frustumCulled = false;
        this.points.visible = false;
        this.points.onBeforeRender = (renderer) => {
            const ratio = this.points.material.uniforms['ratio'];
            if (ratio) {
                ratio.value = renderer.getPixelRatio();
            }
        };
    }

    update(dots: readonly Dot[]): void {
        this.points.visible = dots.length > 0;
        this.points.geometry.dispose();
        const numbers = (values: number[], size: number) =>
            new Float32BufferAttribute(values, size);
        this.points.geometry = new BufferGeometry()
            .setAttribute('position', numbers(dots.flatMap(({ at }) => at), 3))
            .setAttribute('tint',
                numbers(dots.flatMap(({ colour }) => new Color(colour).toArray()), 3))
            .setAttribute('size', numbers(dots.map(({ size }) => size), 1))
            .setAttribute('shape', numbers(dots.map(({ shape }) => kShapes.indexOf(shape)), 1));
    }
}
