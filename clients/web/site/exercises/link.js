// An exercise with its code as a link, and a teacher's own exercise.

function packed(text) {
  const bytes = String.fromCharCode(...new TextEncoder().encode(text));
  return btoa(bytes).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

function unpacked(text) {
  const bytes = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return new TextDecoder("utf-8", { fatal: true }).decode(Uint8Array.from(bytes, (c) => c.charCodeAt(0)));
}

/** The part of an address after #: an exercise, with code. */
export const link_to = (id, code) => `#${id}=${packed(code)}`;

/** The same for an exercise of one's own, on the function of another. */
export const link_to_own = (own) => `#own=${packed(JSON.stringify(own))}`;

/** What an address asks for; a link that was cut off gives the exercise without its code. */
export function read_link(hash) {
  const [id, text] = hash.slice(1).split("=");
  try {
    if (id === "own") {
      const { base, title, text: words, code } = JSON.parse(unpacked(text));
      return { id: String(base), own: { title: String(title), text: String(words) }, code: String(code) };
    }
    return { id, code: text ? unpacked(text) : undefined };
  } catch {
    return { id, isBroken: true };
  }
}
