/// What all shaders of annotations get (kPlaces).
import { Vector2 } from 'three';

export interface SharedUniforms {
    size: { value: Vector2 }; // of the canvas, pixels
    height: { value: number }; // of the picture, pixels
}

export function sharedUniforms(): SharedUniforms {
    return { size: { value: new Vector2(1, 1) }, height: { value: 1 } };
}
