/// Filled in by its own change; an empty area until then.
export function Outline() {
    return <div class="outline" />;
}
