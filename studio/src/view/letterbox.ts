/// The rectangle of the view that the film's picture fills.

/// CSS pixels from the view's upper left corner.
export interface Rectangle {
    left: number;
    top: number;
    width: number;
    height: number;
}

/// The largest rectangle with the film's proportions, in the middle of the view.
export function letterbox(view: { width: number; height: number }, aspect: number): Rectangle {
    const width = Math.min(view.width, view.height * aspect);
    const height = width / aspect;
    return { left: (view.width - width) / 2, top: (view.height - height) / 2, width, height };
}

/// The vertical field of view of the whole view (rad), so that its letterbox shows that of the film.
export function fovOfView(filmFov: number, viewHeight: number, box: Rectangle): number {
    return 2 * Math.atan((Math.tan(filmFov / 2) * viewHeight) / box.height);
}
