// Handles of the time strip, for the checks.

/// What the strip knows of a handle: time, value, text.
export function handleOf(page, id) {
    return page.evaluate((name) => {
        const handle = window.studio.strip.handles.value.find((one) => one.id === name);
        return handle && { time: handle.time, value: handle.value, text: handle.text, y: handle.y,
            label: handle.label };
    }, id);
}

/// Where a handle is on the page, CSS pixels.
export function pixelOfHandle(page, id) {
    return page.evaluate((name) => {
        const { handles, canvas } = window.studio.strip;
        const handle = handles.value.find((one) => one.id === name);
        const { axis, time, y } = handle;
        const box = canvas.getBoundingClientRect();
        const x = axis.left + ((time - axis.from) / (axis.to - axis.from)) * axis.width;
        return [box.left + x, box.top + y];
    }, id);
}

/// Where a film (or scene) time is in a row of the strip, CSS pixels.
export function pixelOnStrip(page, row, time, isFilm, share = 0.5) {
    return page.evaluate(([name, t, film, part]) => {
        const { layout, canvas } = window.studio.strip;
        const rows = layout.value;
        const axis = film ? rows.film : rows.scene;
        const box = canvas.getBoundingClientRect();
        const x = axis.left + ((t - axis.from) / (axis.to - axis.from)) * axis.width;
        return [box.left + x, box.top + rows[name].y + part * rows[name].height];
    }, [row, time, isFilm, share]);
}
