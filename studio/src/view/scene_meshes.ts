/// The meshes of the shot: the .glb of the server, whose nodes are posed by ShotState and timeline.
import { withKey } from '../connection/key';
import {
    Group, Light, Mesh, MeshLambertMaterial, MeshStandardMaterial, Texture,
} from 'three';
import type { Material, Object3D } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import type { Track } from '../motion/track';
import type { ShotState, Triple, Turn } from '../protocol';
import { Instances } from './instances';

const kLampPrefix = 'light '; // before the names of lamps in the list of nodes

/// The same colour without reflections, for pictures that the processor draws. What shares a material
/// shares the simpler one, too.
function simpler(material: Material, made: Map<Material, Material>): Material {
    const one = made.get(material) ?? simplified(material);
    made.set(material, one);
    return one;
}

function simplified(material: Material): Material {
    if (!(material instanceof MeshStandardMaterial)) {
        return material;
    }
    const {
        color, map, emissive, emissiveIntensity, emissiveMap, side, opacity, transparent, alphaTest, depthWrite,
    } = material;
    return new MeshLambertMaterial({
        color, map, emissive, emissiveIntensity, emissiveMap, side, opacity, transparent, alphaTest, depthWrite,
    });
}

/// Releases what the graphics card holds of it.
function release(object: Object3D): void {
    object.traverse((part) => {
        if (part instanceof Mesh) {
            part.geometry.dispose();
            for (const material of [part.material].flat()) {
                for (const value of Object.values(material)) {
                    if (value instanceof Texture) {
                        value.dispose();
                    }
                }
                material.dispose();
            }
        }
    });
}

export class SceneMeshes {
    /// In world axes: the file's Y axis points up, the world's Z axis.
    readonly group = new Group();
    /// Draws what is alike among them.
    readonly instances = new Instances();
    private readonly nodes = new Map<string, Object3D>();
    private hash: string | null = null;

    constructor(private readonly isFast: boolean) {
        this.group.rotation.x = Math.PI / 2;
    }

    /// Loads the meshes of that name in place of those shown. Resolves to whether they are shown: a
    /// later call wins. Rejects if the file cannot be read.
    async load(hash: string): Promise<boolean> {
        this.hash = hash;
        const { scene } = await new GLTFLoader().loadAsync(withKey(`/scene/${hash}.glb`));
        if (this.hash !== hash) {
            release(scene);
            return false;
        }
        release(this.group);
        this.instances.clear();
        this.group.clear();
        this.nodes.clear();
        const made = new Map<Material, Material>();
        for (const node of [...scene.children]) {
            this.adopt(node, made);
        }
        this.instances.take(this.group);
        return true;
    }

    /// The object of that name, or undefined.
    node(name: string): Object3D | undefined {
        return this.nodes.get(name);
    }

    /// The surface of an area light, or undefined.
    lamp(name: string): Object3D | undefined {
        return this.nodes.get(kLampPrefix + name);
    }

    /// Puts every object where it is at a scene time.
    pose(shot: ShotState, tracks: ReadonlyMap<string, Track>, time: number): void {
        this.nameLamps(shot);
        for (const light of shot.lights) {
            const node = this.lamp(light.name);
            if (node) { // the file has it turned, at the origin
                place(node, light.position, [1, 0, 0, 0]);
            }
        }
        for (const object of shot.objects) {
            const node = this.nodes.get(object.name);
            const track = object.moves ? tracks.get(object.track ?? object.name) : undefined;
            if (node) {
                place(node, track?.position(time) ?? object.position,
                    track?.orientation(time) ?? object.orientation);
            }
        }
        this.group.updateMatrixWorld(); // for rays and boxes before the next picture
    }

    /// Lamps and objects may have the same name: lamps come after the objects in the file.
    private nameLamps(shot: ShotState): void {
        const objects = new Set(shot.objects.map((object) => object.name));
        for (const { name } of shot.lights) {
            const node = objects.has(name) ? undefined : this.nodes.get(name);
            if (node) {
                this.nodes.delete(name);
                this.nodes.set(kLampPrefix + name, node);
            }
        }
    }

    private adopt(node: Object3D, made: Map<Material, Material>): void {
        // The loader changes names that it cannot use in paths, and keeps the file's in userData.
        const given: unknown = node.userData['name'];
        const name = typeof given === 'string' ? given : node.name;
        this.nodes.set(this.nodes.has(name) ? kLampPrefix + name : name, node);
        node.traverse((part) => {
            if (part instanceof Light) {
                part.visible = false; // its watts are meant for the renderer
            } else if (part instanceof Mesh && this.isFast) {
                part.material = Array.isArray(part.material)
                    ? part.material.map((one) => simpler(one, made))
                    : simpler(part.material as Material, made);
            }
        });
        this.group.add(node);
    }
}

/// From the world's axes to the file's: (x, y, z) is (x, z, -y) there.
function place(node: Object3D, position: Triple, orientation: Turn): void {
    node.position.set(position[0], position[2], -position[1]);
    node.quaternion.set(orientation[1], orientation[3], -orientation[2], orientation[0]);
}
