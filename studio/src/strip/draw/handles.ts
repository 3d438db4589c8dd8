/// Handles, as far as they are drawn: the rest shows itself by the pointer's shape.
import { xOf } from '../axis';
import type { Handle } from '../handles/handle';
import type { Pen, StripPicture } from './picture';

function path(pen: Pen, { mark, y }: Handle, x: number): void {
    pen.beginPath();
    switch (mark) {
        case 'point':
            pen.arc(x, y, 4, 0, 2 * Math.PI);
            break;
        case 'fade':
            pen.arc(x, y, 3, 0, 2 * Math.PI);
            break;
        case 'tick':
            pen.rect(x - 2.5, y - 2.5, 5, 5);
            break;
        case 'action':
            pen.moveTo(x - 5, y - 5);
            pen.lineTo(x + 5, y - 5);
            pen.lineTo(x, y + 4);
            pen.closePath();
            break;
        default:
            pen.rect(x - 1.5, y - 10, 3, 20);
    }
}

export function drawHandles(pen: Pen, picture: StripPicture): void {
    const { handles, activeHandle, selectedPath, colours, layout } = picture;
    pen.save();
    pen.beginPath();
    pen.rect(layout.film.left - 8, 0, layout.film.width + 16, layout.height);
    pen.clip();
    for (const handle of [...handles].reverse()) {
        const isActive = handle.id === activeHandle;
        const isSelected = handle.path.join('/') === selectedPath && handle.mark !== 'none';
        if (handle.mark === 'none' && !isActive) {
            continue;
        }
        const x = xOf(handle.axis, handle.time);
        path(pen, handle, x);
        pen.fillStyle = isActive || isSelected ? colours.accent
            : handle.mark === 'action' ? colours.named(handle.colour) : colours.surface;
        pen.strokeStyle = isActive || isSelected ? colours.text : colours.named(handle.colour);
        pen.lineWidth = 1.5;
        pen.fill();
        if (handle.mark !== 'none') {
            pen.stroke();
        }
    }
    pen.restore();
}
