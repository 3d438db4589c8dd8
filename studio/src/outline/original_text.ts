/// A thing's text for its copy.
import { sourceOf } from '../edit/edit';
import type { KeyPath } from '../protocol';
import { shot } from '../state/state';

/// A number of seconds as YAML has it.
function seconds(time: number): string {
    return `${Number(time.toFixed(4))} s`;
}

/// The value at a path on one line, for a copy: a camera's copy follows at the end of the film, a
/// ball's copy lies beside it. Null if the text does not have it.
export function originalText(path: KeyPath): string | null {
    const text = sourceOf(path)?.text;
    const state = shot.peek();
    if (!text || !state) {
        return null;
    }
    const key = path.join('/');
    const camera = state.cameras.find((one) => one.path.join('/') === key);
    if (camera) {
        const end = Math.max(...state.cameras.map((one) => one.video_end));
        const video = `[${seconds(end)}, ${seconds(end + camera.video_end - camera.video_start)}]`;
        return text.replace(/video: \[[^\]]*\]/, `video: ${video}`)
            .replace(/name: ([^,}]+)/, `name: ${camera.name}_2`)
            .replace(/, fade: [^,}]+/, '');
    }
    const ball = state.objects.find((one) => one.kind === 'ball' && one.path.join('/') === key);
    if (ball) {
        const [x, y] = ball.position;
        return text.replace(/at: \[[^\]]*\]/,
            `at: [${Number((x + 2.5 * ball.radius).toFixed(3))}, ${Number(y.toFixed(4))}]`);
    }
    return text;
}
