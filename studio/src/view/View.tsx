/// Filled in by its own change; an empty area until then.
export function View() {
    return <div class="view" />;
}
