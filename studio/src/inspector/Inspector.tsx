/// Filled in by its own change; an empty area until then.
export function Inspector() {
    return <div class="inspector" />;
}
