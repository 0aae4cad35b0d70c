// Small helpers for the page's elements.

/** The element of that id. */
export function byId(id) {
  return document.getElementById(id);
}

/** A new element: make('li', {className: 'x'}, child, 'text', ...). */
export function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

const kToast_ms = 7000;

/** Tells the user something; kind 'error' or 'info'. The same text is not shown twice at once. */
export function toast(text, kind = 'info') {
  const box = byId('toasts');
  if ([...box.children].some((child) => child.textContent === text)) return;
  const element = make('div', { className: `toast ${kind}` }, text);
  box.append(element);
  while (box.children.length > 4) box.firstChild.remove();
  setTimeout(() => element.remove(), kToast_ms);
}

/** "1:05.2" of seconds. */
export function clockText(time_s) {
  const minutes = Math.floor(time_s / 60);
  return `${minutes}:${(time_s - 60 * minutes).toFixed(1).padStart(4, '0')}`;
}

/** "about 3 s", "about 2 min" */
export function etaText(eta_s) {
  if (!(eta_s >= 0)) return '';
  return eta_s < 90 ? `about ${Math.max(1, Math.round(eta_s))} s` : `about ${Math.round(eta_s / 60)} min`;
}
