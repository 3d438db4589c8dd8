/// The parts of the view: trails, gizmos, cameras, lights. Each draws its own things and may offer
/// drags; src/view/all_parts.ts lists them.
import type { ReadonlySignal } from '@preact/signals';
import type {
    Object3D, OrthographicCamera, PerspectiveCamera, Ray, Raycaster,
} from 'three';
import type { KeyPath, SceneObject, Triple } from '../protocol';
import type { Rectangle } from './letterbox';
import type { MenuItem } from './menu/menu_state';

export type ViewCamera = PerspectiveCamera | OrthographicCamera;

/// A place on the page, as pointer events and mouse events have it.
export interface Pixel {
    clientX: number;
    clientY: number;
}

/// What a part of the view gets.
export interface ViewContext {
    readonly canvas: HTMLCanvasElement;
    /// To add things to. Drawn after the meshes of the shot and after the path-traced picture, for
    /// which renderOrder is 1: groups are sorted by it, then what is in them.
    readonly scene: Object3D;
    /// Counts the changes of the camera and of the view's size.
    readonly moved: ReadonlySignal<number>;
    /// Counts the meshes that were loaded: after it the nodes of the objects are others.
    readonly loaded: ReadonlySignal<number>;
    /// The one that is looked through now.
    camera(): ViewCamera;
    /// The ray from the camera through a pixel, in the world.
    rayAt(pixel: Pixel): Ray;
    raycasterAt(pixel: Pixel): Raycaster;
    /// CSS pixels from the canvas's upper left corner; null behind the camera.
    toScreen(point: Triple): [number, number] | null;
    /// The length that one CSS pixel shows at that point, m.
    metresPerPixel(point: Triple): number;
    /// Of the canvas, CSS pixels.
    size(): { width: number; height: number };
    /// Pixels of the canvas along a CSS pixel.
    pixelRatio(): number;
    /// The film's rectangle in CSS pixels of the canvas; the whole canvas in the free view.
    box(): Rectangle;
    /// The meshes of an object of the shot; null until they are loaded.
    meshNode(name: string): Object3D | null;
    /// The nearest object of the shot at a pixel, the table too.
    objectAt(pixel: Pixel): SceneObject | null;
    /// Draws at the display's next frame.
    ask(): void;
}

/// A drag that began: one gesture of src/edit. After `end` or `cancel` nothing more is called.
export interface Drag {
    move(event: PointerEvent): void;
    end(event: PointerEvent): void;
    cancel(): void;
}

/// Of all parts, from the largest priority to the smallest, the first that returns a drag gets the
/// pointer until it is released; the camera stays where it is meanwhile. Escape cancels the drag.
export interface ViewPart {
    readonly priority: number;
    /// For a press of the main button.
    grab?(event: PointerEvent): Drag | null;
    /// For a pointer without a pressed button: a CSS cursor if `grab` would return a drag here.
    hover?(event: PointerEvent): string | null;
    /// What a click selects here; null: the part has nothing here.
    pick?(pixel: Pixel): KeyPath | null;
    /// Items of the menu for a place.
    menu?(pixel: Pixel): readonly MenuItem[];
    dispose(): void;
}

export type MakePart = (context: ViewContext) => ViewPart;

/// The priorities: handles lie before the bodies of the scene, bodies before what only draws.
export const kHandlePriority = 30;
export const kGizmoPriority = 20;
export const kBodyPriority = 10;
export const kDrawingPriority = 0;

