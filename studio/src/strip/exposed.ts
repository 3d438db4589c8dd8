/// What tests see of the strip: `window.studio.strip`.
import { tracks } from '../motion/clock';
import { sceneTimeAt } from '../motion/time_map';
import { sceneTime, shot } from '../state/state';
import { shownHandles } from './handles/all_handles';
import { otherInstants } from './instants';
import { currentLayout } from './layout_now';
import { linesOf } from './map_lines';
import { currentEvent } from './strip_state';

export function exposeStrip(canvas: HTMLCanvasElement): void {
    window.studio['strip'] = {
        handles: shownHandles, layout: currentLayout, others: otherInstants, event: currentEvent,
        canvas, sceneTimeAt,
        placeOf: (name: string) => tracks.peek().get(name)?.position(sceneTime.peek()),
        lines: (index: number) => {
            const camera = shot.peek()?.cameras[index];
            return camera ? linesOf(camera, currentLayout.peek().film)
                .map((film) => ({ film, scene: sceneTimeAt(camera, film) })) : [];
        },
    };
}
