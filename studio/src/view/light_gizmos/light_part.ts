/// The lights of the shot in the view.
import { computed, effect } from '@preact/signals';
import { originOf } from '../../edit/edit';
import type { KeyPath, SceneLight } from '../../protocol';
import { lookThrough, selection, shot } from '../../state/state';
import { showLights } from '../../state/view_state';
import { pixelDistance } from '../gizmos/dragging';
import { together } from '../gizmos/figure';
import { sketchOf } from '../gizmos/sketch';
import { handleSet } from '../handles/handle_part';
import { kHandlePriority, type MakePart, type Pixel, type ViewContext } from '../parts';
import { lightFigure, placeOf } from './light_figure';
import { lightHandles } from './light_handles';

const kReach = 10; // CSS pixels

/// The lights that are shown; none while the view looks through a camera.
const lights = computed((): readonly SceneLight[] =>
    (showLights.value && lookThrough.value === null ? shot.value?.lights ?? [] : []));

function isChosen(light: SceneLight, chosen: KeyPath | null): boolean {
    return chosen?.[0] === 'lights' && chosen[1] === light.name;
}

/// Lights that no file names are those of a shot without lights; they have no values to change.
const handles = computed(() => lights.value
    .filter((light) => isChosen(light, selection.value) && originOf(light.path) !== 'absent')
    .flatMap(lightHandles));

function lightAt(context: ViewContext, pixel: Pixel): KeyPath | null {
    return lights.peek().find((light) => {
        const at = placeOf(light);
        return at && pixelDistance(context, at, pixel) < kReach;
    })?.path ?? null;
}

export const makeLights: MakePart = (context) => {
    const sketch = sketchOf(context);
    const set = handleSet(handles, context);
    const ends = [
        effect(() => sketch.show('lights', together(...lights.value.map((light) =>
            lightFigure(light, isChosen(light, selection.value)))))),
        effect(() => sketch.show('light handles', set.figure())),
    ];
    if (window.studio) {
        window.studio['lightHandles'] = set.shown; // for tests
    }
    return {
        priority: kHandlePriority,
        grab: set.grab,
        hover: (event) => set.hover(event) ?? (lightAt(context, event) ? 'pointer' : null),
        pick: (pixel) => set.pick(pixel) ?? lightAt(context, pixel),
        dispose: () => {
            ends.forEach((end) => end());
            sketch.dispose();
        },
    };
};
