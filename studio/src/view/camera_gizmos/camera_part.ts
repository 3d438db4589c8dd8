/// The cameras of the shot in the view: paths, the lens at the play head, and all handles.
import { computed, effect } from '@preact/signals';
import { cameraLookedThrough, filmCamera, framesOfCameras } from '../../motion/clock';
import type { KeyPath } from '../../protocol';
import { filmTime, lookThrough, selection, shot } from '../../state/state';
import { showCameras } from '../../state/view_state';
import { pixelDistance } from '../gizmos/dragging';
import { together } from '../gizmos/figure';
import { followAxisKeys } from '../gizmos/held_axis';
import { sketchOf } from '../gizmos/sketch';
import type { Handle } from '../handles/handle';
import { handleSet } from '../handles/handle_part';
import { kHandlePriority, type MakePart, type Pixel, type ViewContext } from '../parts';
import { cameraColour, targetColour } from './camera_colours';
import { lensFigure, lensHandles, type LensNow } from './lens_handles';
import { lookFigure, pathFigure, tickFigure } from './path_figure';
import { drawnPaths, pathHandles } from './path_handles';

const kPathReach = 6; // CSS pixels from a path that is clicked
const kCameraReach = 12; // from the camera at the play head

/// The index of the selected camera, or of that to which the selected value belongs; -1 without.
const selectedCamera = computed(() => {
    const chosen = selection.value;
    const at = chosen?.[0] === 'cameras' ? Number(chosen[1]) : -1;
    return at in (shot.value?.cameras ?? []) ? at : -1;
});

/// The camera that is drawn in full: the one that is looked through, the selected one, or that of the
/// play head.
export const activeCamera = computed(() => {
    const through = cameraLookedThrough.value;
    return through >= 0 ? through
        : selectedCamera.value >= 0 ? selectedCamera.value : filmCamera.value;
});

/// The active camera's lens at the play head, or at the nearest end of its interval.
export const activeLens = computed((): LensNow | null => {
    const index = activeCamera.value;
    const camera = shot.value?.cameras[index];
    const frames = framesOfCameras.value[index];
    const film = shot.value?.film;
    if (!camera || !film || !frames || frames.count === 0) {
        return null;
    }
    const time = Math.min(Math.max(filmTime.value, camera.video_start), camera.video_end);
    const pose = frames.poseAt(time);
    return pose && {
        camera, pose, first: frames.at(0).pose, last: frames.at(frames.count - 1).pose,
        progress: (time - camera.video_start) / (camera.video_end - camera.video_start),
        aspect: film.height > 0 ? film.width / film.height : 16 / 9,
        colour: cameraColour(index),
    };
});

/// Only the selected camera has handles, so that they do not lie over balls. While the view looks
/// through it, only what it looks at is shown.
const handles = computed((): Handle[] => {
    const index = selectedCamera.value;
    const camera = shot.value?.cameras[index];
    if (!camera || !showCameras.value) {
        return [];
    }
    const paths = drawnPaths(camera, cameraColour(index), targetColour(index));
    if (lookThrough.value !== null) {
        return index === cameraLookedThrough.value
            ? paths.filter(({ part }) => part === 'target').flatMap(pathHandles) : [];
    }
    const lens = activeLens.value;
    return [...(lens ? lensHandles(lens) : []), ...paths.flatMap(pathHandles)];
});

/// What stands still while the play head moves.
const pathsFigure = computed(() => {
    if (!showCameras.value) {
        return {};
    }
    const through = lookThrough.value;
    const cameras = shot.value?.cameras ?? [];
    const paths = cameras.flatMap((camera, i) => {
        const isActive = i === activeCamera.value;
        const isSelected = i === selectedCamera.value;
        const colour = cameraColour(i);
        const drawn = drawnPaths(camera, colour, targetColour(i)).filter(({ part }) =>
            through === null ? isSelected || part === 'position'
                : isActive && part === 'target' && i === cameraLookedThrough.value);
        const frames = framesOfCameras.value[i];
        const ticks = through === null && frames ? [tickFigure(frames, colour, isActive)] : [];
        const looks = through === null && frames && isSelected ? [lookFigure(frames, colour)] : [];
        return [...drawn.map((path) => pathFigure(path, isSelected)), ...ticks, ...looks];
    });
    return together(...paths);
});

const lensNowFigure = computed(() => {
    const lens = showCameras.value && lookThrough.value === null ? activeLens.value : null;
    return lens ? lensFigure(lens, selectedCamera.value >= 0) : {};
});

/// The camera whose path is at a pixel.
function cameraAt(context: ViewContext, pixel: Pixel): KeyPath | null {
    if (!showCameras.peek() || lookThrough.peek() !== null) {
        return null;
    }
    const cameras = shot.peek()?.cameras ?? [];
    const lens = activeLens.peek();
    if (lens && pixelDistance(context, lens.pose.position, pixel) < kCameraReach) {
        return lens.camera.path;
    }
    const found = cameras.find(({ position }, i) => {
        const frames = framesOfCameras.peek()[i];
        const places = frames && position.curve.length === 0 && frames.count > 0
            ? [...frames.at(0).pose.position] : position.curve;
        return places.some((_, at) => at % 3 === 0
            && pixelDistance(context, [places[at] ?? 0, places[at + 1] ?? 0, places[at + 2] ?? 0],
                pixel) < kPathReach);
    });
    return found?.path ?? null;
}

export const makeCameras: MakePart = (context) => {
    const sketch = sketchOf(context);
    const set = handleSet(handles, context);
    const ends = [
        followAxisKeys(),
        effect(() => sketch.show('cameras', pathsFigure.value)),
        effect(() => sketch.show('lens', lensNowFigure.value, 'moving')),
        effect(() => sketch.show('camera handles', set.figure(), 'moving')),
    ];
    if (window.studio) {
        window.studio['cameraHandles'] = set.shown; // for tests
    }
    return {
        priority: kHandlePriority,
        grab: set.grab,
        hover: (event) => set.hover(event) ?? (cameraAt(context, event) ? 'pointer' : null),
        pick: (pixel) => set.pick(pixel) ?? cameraAt(context, pixel),
        dispose: () => {
            ends.forEach((end) => end());
            sketch.dispose();
        },
    };
};
