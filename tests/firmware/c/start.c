/* From reset to main without a C library's start-up code, which nothing here needs. */
#include <stdint.h>

extern uint32_t stack_top[], bss_start[], bss_end[];
int main(void);

__attribute__((naked)) static void start(void) {
#ifdef __ARM_FP
    *(volatile uint32_t *)0xe000ed88 |= 0xf << 20; /* switch the FPU on */
    __asm__ volatile("dsb\nisb");
#endif
    __asm__ volatile("b enter");
}

__attribute__((used)) void enter(void) {
    for (volatile uint32_t *word = bss_start; word < bss_end; word++) *word = 0;
    main();
    for (;;);
}

__attribute__((used, section(".vectors"))) static const void *const vectors[16] = {
    stack_top, (const void *)start};
