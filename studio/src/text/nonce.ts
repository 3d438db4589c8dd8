/// The page's nonce for style elements, which its content security policy asks for.
export function pageNonce(): string {
    return document.querySelector('meta[name="csp-nonce"]')?.getAttribute('content') ?? '';
}
