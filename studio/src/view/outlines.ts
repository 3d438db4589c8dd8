/// Lines around what is selected and what the pointer is over: the back faces of the mesh, moved
/// outwards by some pixels.
import { effect } from '@preact/signals';
import {
    BackSide, BufferGeometry, Color, Float32BufferAttribute, Mesh, ShaderMaterial, Vector2,
    type Object3D,
} from 'three';
import type { KeyPath } from '../protocol';
import { hovered, selection, shot } from '../state/state';
import { kBodyPriority, type MakePart } from './parts';
import { viewColours } from './theme_colours';

const kVertexShader = `
uniform vec2 size;
uniform float width;
void main() {
    vec4 at = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    vec4 out_ = projectionMatrix * modelViewMatrix * vec4(position + 1e-4 * normal, 1.0);
    vec2 way = (out_.xy / out_.w - at.xy / at.w) * size;
    float far = length(way);
    at.xy += (far > 0.0 ? way / far : vec2(0.0)) * width * 2.0 / size * at.w;
    gl_Position = at;
}`;
const kFragmentShader = `
uniform vec3 colour;
void main() {
    gl_FragColor = vec4(colour, 1.0);
    #include <colorspace_fragment>
}`;

/// The mesh with one normal at each place, so that moved faces stay connected.
function connected(mesh: Mesh): BufferGeometry {
    const place = mesh.geometry.getAttribute('position');
    const index = mesh.geometry.getIndex();
    const count = index ? index.count : place.count;
    const corner = (i: number) => (index ? index.getX(i) : i);
    const key = (i: number) => [place.getX(i), place.getY(i), place.getZ(i)]
        .map((value) => Math.round(value * 1e6)).join();
    const numbers = new Map<string, number>();
    const points: number[] = [];
    const corners = Array.from({ length: count }, (_, i) => {
        const at = corner(i);
        const name = key(at);
        let number = numbers.get(name);
        if (number === undefined) {
            number = points.length / 3;
            numbers.set(name, number);
            points.push(place.getX(at), place.getY(at), place.getZ(at));
        }
        return number;
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
    geometry.setIndex(corners);
    geometry.computeVertexNormals();
    return geometry;
}

class Outline {
    private readonly material: ShaderMaterial;
    private readonly lines: Mesh[] = [];
    private of: Object3D | null = null;

    constructor(width: number, private readonly size: Vector2) {
        this.material = new ShaderMaterial({
            side: BackSide, vertexShader: kVertexShader, fragmentShader: kFragmentShader,
            uniforms: { size: { value: size }, width: { value: width }, colour: { value: new Color() } },
        });
    }

    setColour(colour: string): void {
        this.material.uniforms['colour']?.value.set(colour);
    }

    /// Draws it around all meshes of an object, or around nothing.
    around(object: Object3D | null): void {
        if (object === this.of) {
            return;
        }
        this.clear();
        this.of = object;
        const meshes: Mesh[] = [];
        object?.traverse((part) => {
            if (part instanceof Mesh) {
                meshes.push(part);
            }
        });
        for (const mesh of meshes) {
            const line = new Mesh(connected(mesh), this.material);
            line.raycast = () => {};
            line.frustumCulled = false;
            mesh.add(line);
            this.lines.push(line);
        }
    }

    clear(): void {
        this.of = null;
        for (const line of this.lines.splice(0)) {
            line.removeFromParent();
            line.geometry.dispose();
        }
    }

    setSize(width: number, height: number): void {
        this.size.set(width, height);
    }

    dispose(): void {
        this.clear();
        this.material.dispose();
    }
}

/// The object of the shot at a key path or above it.
function objectOf(path: KeyPath | null): string | null {
    const objects = path ? shot.value?.objects ?? [] : [];
    return objects.find((one) => one.kind !== 'table' && one.path.length <= (path?.length ?? 0)
        && one.path.every((key, i) => path?.[i] === key))?.name ?? null;
}

export const makeOutlines: MakePart = (context) => {
    const colours = viewColours();
    const selected = new Outline(2.5, new Vector2(1, 1));
    const pointedAt = new Outline(1.5, new Vector2(1, 1));
    const node = (name: string | null) => (name === null ? null : context.meshNode(name));
    const ends = [
        effect(() => {
            selected.setColour(colours.value.accent);
            pointedAt.setColour(colours.value.soft);
            context.ask();
        }),
        effect(() => {
            void [context.moved.value, context.loaded.value];
            const { width, height } = context.size();
            [selected, pointedAt].forEach((one) => one.setSize(width, height));
        }),
        effect(() => {
            void context.loaded.value;
            const name = objectOf(selection.value);
            const other = objectOf(hovered.value);
            selected.around(node(name));
            pointedAt.around(other === name ? null : node(other));
            context.ask();
        }),
    ];
    return {
        priority: kBodyPriority - 5,
        hover: (event) => {
            const object = context.objectAt(event);
            const path = object && object.kind !== 'table' ? object.path : null;
            if (path?.join('/') !== hovered.peek()?.join('/')) {
                hovered.value = path;
            }
            return path ? 'pointer' : null;
        },
        dispose: () => {
            ends.forEach((end) => end());
            selected.dispose();
            pointedAt.dispose();
        },
    };
};
