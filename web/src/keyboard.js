// Keys that are down, and what single keys do. Keys typed into a field are its own.

const isField = (element) => element instanceof HTMLElement && (element.matches('input:not([type=checkbox]), textarea, select') || element.closest('dialog'));

/**
 * @param shortcuts code -> function
 * @returns {Set<string>} codes of the keys that are down
 */
export function listenToKeys(shortcuts) {
  const down = new Set();
  addEventListener('keydown', (event) => {
    if (isField(event.target) || event.ctrlKey || event.metaKey || event.altKey) return;
    const onButton = event.target instanceof HTMLButtonElement && (event.code === 'Space' || event.code === 'Enter');
    if (onButton) return;
    if (event.code.startsWith('Arrow') && event.target.role !== 'tab') event.preventDefault();
    if (!event.repeat && shortcuts[event.code]) {
      event.preventDefault();
      shortcuts[event.code]();
    }
    down.add(event.code);
  });
  addEventListener('keyup', (event) => down.delete(event.code));
  addEventListener('blur', () => down.clear());
  return down;
}
