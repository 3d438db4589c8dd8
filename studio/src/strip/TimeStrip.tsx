/// Filled in by its own change; an empty area until then.
export function TimeStrip() {
    return <div class="strip" />;
}
