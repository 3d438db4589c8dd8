/// Texts of annotations, at their places of the scene and with their depth.
import {
    CanvasTexture, CustomBlending, LinearFilter, Mesh, OneFactor, OneMinusSrcAlphaFactor, PlaneGeometry,
    ShaderMaterial, Vector3, Vector4, type Object3D,
} from 'three';
import type { Triple } from '../../protocol';
import { kNowhere, kPlaces } from './shaders';
import { drawText, sizeOfText, type ShownText } from './text_picture';
import type { SharedUniforms } from './uniforms';

export interface PlacedText extends ShownText {
    at: Triple;
    opacity: number;
}

const kVertexShader = `
uniform vec3 at;
uniform float nearer; // m
uniform vec4 box; // from the place to the lower left corner, and its size; pixels
varying vec2 inBox;
${kPlaces}
void main() {
    vec3 place = placeOf(at);
    if (isBehind(place)) {
        gl_Position = ${kNowhere};
        return;
    }
    vec2 pixel = floor(onCanvas(place).xy + box.xy + 0.5);
    place.z = hasPerspective() ? min(place.z + nearer, -kNear) : place.z + nearer;
    inBox = position.xy + 0.5;
    gl_Position = fromCanvas(pixel + inBox * box.zw, onCanvas(place).z);
}`;

const kFragmentShader = `
uniform sampler2D picture;
uniform float opacity;
varying vec2 inBox;
void main() {
    gl_FragColor = opacity * texture2D(picture, inBox);
}`;

const kSquare = new PlaneGeometry(1, 1);

class Text {
    readonly mesh: Mesh<PlaneGeometry, ShaderMaterial>;
    private readonly canvas = document.createElement('canvas');
    private picture: CanvasTexture | null = null;
    private drawn = '';

    constructor(
        private readonly uniforms: SharedUniforms,
    ) {
        this.mesh = new Mesh(kSquare, new ShaderMaterial({
            vertexShader: kVertexShader, fragmentShader: kFragmentShader,
            uniforms: {
                ...uniforms, at: { value: new Vector3() }, nearer: { value: 0 },
                box: { value: new Vector4() }, picture: { value: null }, opacity: { value: 1 },
            },
            transparent: true, depthWrite: false, blending: CustomBlending, // premultiplied
            blendSrc: OneFactor, blendDst: OneMinusSrcAlphaFactor,
        }));
        this.mesh.frustumCulled = false;
        this.mesh.raycast = () => {};
    }

    update(text: PlacedText): void {
        const { label, at, opacity } = text;
        const height = this.uniforms.height.value;
        const [width, high] = sizeOfText(label, height);
        (this.uniform('at').value as Vector3).set(...at);
        this.uniform('nearer').value = label.nearer;
        this.uniform('opacity').value = opacity;
        (this.uniform('box').value as Vector4).set(label.offset[0] * height - width / 2,
            label.offset[1] * height - (label.is_above ? 0 : high / 2), width, high);
        const key = JSON.stringify([label, text.colour, text.boxColour, text.edge, height]);
        if (key !== this.drawn) {
            this.drawn = key;
            this.draw(text, height);
        }
    }

    dispose(): void {
        this.mesh.removeFromParent();
        this.mesh.material.dispose();
        this.picture?.dispose();
    }

    private draw(text: PlacedText, height: number): void {
        drawText(this.canvas, text, height);
        this.picture?.dispose(); // its size changes with the text
        this.picture = new CanvasTexture(this.canvas);
        this.picture.premultiplyAlpha = true;
        this.picture.generateMipmaps = false;
        this.picture.minFilter = LinearFilter;
        this.uniform('picture').value = this.picture;
    }

    private uniform(name: string): { value: unknown } {
        return this.mesh.material.uniforms[name] as { value: unknown };
    }
}

export class Texts {
    private readonly all: Text[] = [];

    /// `parent` gets them, with that order of drawing.
    constructor(
        private readonly parent: Object3D, private readonly order: number,
        private readonly uniforms: SharedUniforms,
    ) {}

    update(texts: readonly PlacedText[]): void {
        this.all.splice(texts.length).forEach((text) => text.dispose());
        texts.forEach((text, i) => {
            const one = this.all[i] ?? new Text(this.uniforms);
            if (i === this.all.length) {
                one.mesh.renderOrder = this.order + i;
                this.parent.add(one.mesh);
                this.all.push(one);
            }
            one.update(text);
        });
    }

    dispose(): void {
        this.update([]);
    }
}
