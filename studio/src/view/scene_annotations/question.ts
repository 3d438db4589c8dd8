/// What the page asks about the annotations in the scene.
import { OrthographicCamera, Vector3 } from 'three';
import { filmCamera } from '../../motion/clock';
import { speedAt } from '../../motion/time_map';
import type { FreeView, SeeAnnotations } from '../../protocol';
import { filmTime, sceneTime, shot, timeline } from '../../state/state';
import { isInScene } from '../annotation_boxes';
import type { ViewCamera, ViewContext } from '../parts';
import { viewOf } from '../picture/question';

export type Question = Omit<SeeAnnotations, 'q'>;

const kFar = 100; // m: from there a view with perspective is nearly one without

function farView(camera: OrthographicCamera, sceneTime: number): FreeView {
    camera.updateMatrixWorld();
    const back = new Vector3().setFromMatrixColumn(camera.matrixWorld, 2);
    const height = (camera.top - camera.bottom) / camera.zoom;
    return {
        scene_time: sceneTime,
        position: camera.position.clone().addScaledVector(back, kFar).toArray(),
        target: camera.position.toArray(),
        up: new Vector3().setFromMatrixColumn(camera.matrixWorld, 1).toArray(),
        fov: 2 * Math.atan(height / 2 / kFar),
        focus: 1,
        lens_radius: 0,
    };
}

/// The view of what stands for the film's picture: its rectangle, or all of the canvas.
function pictureView(camera: ViewCamera, context: ViewContext, sceneTime: number): FreeView | null {
    const view = camera instanceof OrthographicCamera ? farView(camera, sceneTime)
        : viewOf(camera, sceneTime);
    const share = context.box().height / context.size().height;
    return view && { ...view, fov: 2 * Math.atan(Math.tan(view.fov / 2) * share) };
}

/// For the play head and the view's camera; null if there is nothing to ask about.
export function questionNow(context: ViewContext): Question | null {
    void context.moved.value;
    const state = shot.value;
    const motion = timeline.value;
    if (!state || !motion || !state.annotations.some(isInScene)) {
        return null;
    }
    const view = pictureView(context.camera(), context, sceneTime.value);
    const camera = state.cameras[filmCamera.value];
    const time = filmTime.value;
    return view && {
        v: motion.head.v, view, frame: Math.floor(time * state.film.fps + 1e-6), video_time: time,
        playback_speed: camera ? speedAt(camera, time) : 1,
    };
}
