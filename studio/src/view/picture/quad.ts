/// The picture as a rectangle of the canvas: over the meshes, below trails and handles.
import {
    CustomBlending, DataTexture, GLSL3, Group, LinearFilter, Mesh, NearestFilter, NoColorSpace, PlaneGeometry,
    RawShaderMaterial, RGBAFormat, UnsignedByteType, Vector4,
} from 'three';
import type { Picture } from '../../state/state';
import type { Rectangle } from '../letterbox';

const kOrder = 1; // of the groups: meshes have 0, trails and handles 2

const kVertexShader = `
in vec3 position;
uniform vec4 box; // left, bottom, right, top in clip space
out vec2 place;
void main() {
    place = position.xy + 0.5;
    gl_Position = vec4(mix(box.xy, box.zw, place), 0.0, 1.0);
}`;

const kFragmentShader = `
precision highp float;
in vec2 place;
uniform sampler2D newest;
uniform sampler2D kept;
uniform float wipe; // below 0: the newest alone
uniform float lineWidth;
uniform float opacity;
out vec4 colour;
void main() {
    vec2 at = vec2(place.x, 1.0 - place.y);
    vec3 value = place.x < wipe ? texture(kept, at).rgb : texture(newest, at).rgb;
    if (wipe >= 0.0 && abs(place.x - wipe) < lineWidth) {
        value = vec3(1.0);
    }
    colour = vec4(value, opacity);
}`;

function textureOf({ head, pixels }: Picture): DataTexture {
    const bytes = new Uint8Array(pixels.buffer, pixels.byteOffset, pixels.byteLength);
    const texture = new DataTexture(
        bytes, head.width, head.height, RGBAFormat, UnsignedByteType);
    texture.colorSpace = NoColorSpace;
    texture.minFilter = LinearFilter;
    texture.magFilter = head.complete ? NearestFilter : LinearFilter;
    texture.needsUpdate = true;
    return texture;
}

/// Small rounds have rounded sizes.
function haveSameShape(a: Picture, b: Picture): boolean {
    const ratio = (a.head.width * b.head.height) / (a.head.height * b.head.width);
    return Math.abs(ratio - 1) < 0.03;
}

export class PictureQuad {
    readonly group = new Group();
    private readonly material = new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: kVertexShader,
        fragmentShader: kFragmentShader,
        depthTest: false,
        depthWrite: false,
        blending: CustomBlending, // in the order of opaque objects, so that handles follow
        uniforms: {
            box: { value: new Vector4(-1, -1, 1, 1) },
            newest: { value: null },
            kept: { value: null },
            wipe: { value: -1 },
            lineWidth: { value: 0 },
            opacity: { value: 1 },
        },
    });
    private readonly pictures = new Map<string, Picture>();

    constructor() {
        const quad = new Mesh(new PlaneGeometry(1, 1), this.material);
        quad.frustumCulled = false;
        this.group.add(quad);
        this.group.renderOrder = kOrder;
        this.group.visible = false;
    }

    /// `box` in CSS pixels of a canvas of that size.
    place(box: Rectangle, canvas: { width: number; height: number }): void {
        const x = (pixel: number) => (2 * pixel) / canvas.width - 1;
        const y = (pixel: number) => 1 - (2 * pixel) / canvas.height;
        this.value('box').set(
            x(box.left), y(box.top + box.height), x(box.left + box.width), y(box.top));
        this.uniform('lineWidth').value = 1 / box.width;
    }

    /// Shows nothing without a newest picture, and a kept one only if it has the same proportions.
    show(newest: Picture | null, kept: Picture | null, wipe: number, opacity: number): void {
        this.group.visible = newest !== null;
        this.set('newest', newest);
        this.set('kept', kept);
        this.uniform('wipe').value = newest && kept && haveSameShape(newest, kept) ? wipe : -1;
        this.uniform('opacity').value = opacity;
    }

    dispose(): void {
        this.group.removeFromParent();
        this.set('newest', null);
        this.set('kept', null);
        this.material.dispose();
    }

    private set(name: 'newest' | 'kept', picture: Picture | null): void {
        if (this.pictures.get(name) === picture && picture) {
            return;
        }
        const uniform = this.uniform(name);
        (uniform.value as DataTexture | null)?.dispose();
        uniform.value = picture && textureOf(picture);
        picture ? this.pictures.set(name, picture) : this.pictures.delete(name);
    }

    private uniform(name: string): { value: unknown } {
        const uniform = this.material.uniforms[name];
        if (!uniform) {
            throw new Error(`the shader has no '${name}'`);
        }
        return uniform;
    }

    private value(name: string): Vector4 {
        return this.uniform(name).value as Vector4;
    }
}
