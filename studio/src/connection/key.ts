/// The keys of the server. They come behind the "#" of the address and are kept in this browser's
/// storage, which belongs to this host and port alone: a cookie would be sent to every server of this
/// machine, whatever its port. docs/developers/studio_security.md.

const kKey = 'carom.key'; // for the socket
const kReadKey = 'carom.read_key'; // for all other addresses

/// Keeps the keys that the address has, and takes them out of it.
export function takeKeys(): void {
    const given = new URLSearchParams(location.hash.slice(1));
    const [key, read] = [given.get('key'), given.get('read')];
    if (key && read) {
        localStorage.setItem(kKey, key);
        localStorage.setItem(kReadKey, read);
        history.replaceState(null, '', location.pathname);
    }
}

/// The newest key, which another window may have got; empty if there is none.
export function newestKey(): string {
    return localStorage.getItem(kKey) ?? '';
}

/// Calls `change` when another window gets a key.
export function onNewKey(change: () => void): void {
    window.addEventListener('storage', ({ key }) => {
        if (key === kReadKey) { // written last
            change();
        }
    });
}

/// The address, for the browser, of what the server has at a path such as "/film/1.mp4".
export function withKey(path: string): string {
    return `/${localStorage.getItem(kReadKey) ?? ''}${path}`;
}
