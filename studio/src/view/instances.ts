/// Draws the many meshes of a shot that share their shape and material, such as dominoes, with one call.
/// The meshes stay where they are, for rays, outlines and edges; only the view's cameras do not draw
/// them.
import { DynamicDrawUsage, Group, InstancedMesh, Mesh, type Material, type Object3D } from 'three';

/// Of meshes that are drawn as instances; rays and the test of object ids see it, too.
export const kInstancedLayer = 1;

const kFewest = 8; // meshes; fewer are drawn by themselves

interface Batch {
    drawn: InstancedMesh;
    parts: Mesh[];
}

/// Whether a mesh and everything above it up to `top` is shown.
function isShown(part: Object3D, top: Object3D): boolean {
    for (let one: Object3D | null = part; one && one !== top; one = one.parent) {
        if (!one.visible) {
            return false;
        }
    }
    return true;
}

/// The meshes below `top` by their geometry and material.
function alike(top: Object3D): Map<string, Mesh[]> {
    const found = new Map<string, Mesh[]>();
    top.traverse((part) => {
        if (part instanceof Mesh && !Array.isArray(part.material)) {
            const key = `${part.geometry.uuid} ${(part.material as Material).uuid}`;
            const parts = found.get(key) ?? [];
            parts.push(part);
            found.set(key, parts);
        }
    });
    return found;
}

export class Instances {
    /// In the world: not below what is turned.
    readonly group = new Group();
    private batches: Batch[] = [];
    private top: Object3D | null = null;

    /// Draws what is alike below `top` from now on.
    take(top: Object3D): void {
        this.clear();
        this.top = top;
        for (const parts of alike(top).values()) {
            const first = parts[0];
            if (first && parts.length >= kFewest) {
                const drawn = new InstancedMesh(first.geometry, first.material, parts.length);
                drawn.instanceMatrix.setUsage(DynamicDrawUsage);
                drawn.frustumCulled = false;
                drawn.raycast = () => {};
                parts.forEach((part) => part.layers.set(kInstancedLayer));
                this.group.add(drawn);
                this.batches.push({ drawn, parts });
            }
        }
    }

    /// Puts the instances where the meshes are, whose matrices have to be up to date.
    place(): void {
        for (const { drawn, parts } of this.batches) {
            const shown = parts.filter((part) => this.top && isShown(part, this.top));
            shown.forEach((part, i) => drawn.setMatrixAt(i, part.matrixWorld));
            drawn.count = shown.length;
            drawn.visible = shown.length > 0;
            drawn.instanceMatrix.needsUpdate = true;
        }
    }

    clear(): void {
        this.batches.splice(0).forEach(({ drawn }) => {
            drawn.removeFromParent();
            drawn.dispose();
        });
    }
}
