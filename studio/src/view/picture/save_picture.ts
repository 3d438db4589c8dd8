/// Saves the traced picture that is shown as a PNG, whatever it shows: a frame, a channel, a free view.
import type { Picture } from '../../state/state';
import { sequence, shot } from '../../state/state';
import { channel, shownFrame } from './picture_state';

/// "nine_ball_break_84.png", "nine_ball_break_view_depth.png".
export function pictureName(shotName: string, frame: number | null, channelName: string): string {
    const name = shotName.replace(/^.*\//, '').replace(/\.ya?ml$/, '');
    return [name || 'shot', frame ?? 'view', ...channelName === '' ? [] : [channelName]]
        .join('_') + '.png';
}

/// A picture on a canvas of its own size.
export function drawOn(canvas: HTMLCanvasElement, { head, pixels }: Picture): void {
    canvas.width = head.width;
    canvas.height = head.height;
    canvas.getContext('2d')?.putImageData(new ImageData(pixels, head.width, head.height), 0, 0);
}

export function savePicture(picture: Picture): void {
    const canvas = document.createElement('canvas');
    drawOn(canvas, picture);
    canvas.toBlob((blob) => {
        if (blob) {
            const link = document.createElement('a');
            link.href = URL.createObjectURL(blob);
            link.download = pictureName((shot.peek() ?? sequence.peek())?.name ?? '', shownFrame.peek(), channel.peek());
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
        }
    });
}
