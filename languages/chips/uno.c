/* An Uno with a display, emulated: runs the firmware that is named, writes the first picture that its display gets to a PPM,
   and prints the digest of the picture and how long an Uno takes for it. */
#include <avr_ioport.h>
#include <avr_spi.h>
#include <sim_avr.h>
#include <sim_elf.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { PIXELS = 240 * 240, MEMORY_WRITE = 0x2C };

static uint8_t is_data, last_command;
static uint32_t received;
static uint8_t memory[2 * PIXELS];

static void on_pin(struct avr_irq_t *irq, uint32_t value, void *unused) {
    (void)irq, (void)unused;
    is_data = value & 1;
}

static void on_byte(struct avr_irq_t *irq, uint32_t value, void *unused) {
    (void)irq, (void)unused;
    if (!is_data) {
        last_command = (uint8_t)value;
    } else if (last_command == MEMORY_WRITE && received < sizeof memory) {
        memory[received++] = (uint8_t)value;
    }
}

/* FNV-1a over the pixels, the lower byte of each first. */
static uint64_t digest(void) {
    uint64_t hash = 0xCBF29CE484222325u;
    for (size_t i = 0; i < sizeof memory; i++) hash = (hash ^ memory[i ^ 1]) * 0x100000001B3u;
    return hash;
}

static int save(const char *path) {
    FILE *file = fopen(path, "wb");
    if (!file) return 0;
    fprintf(file, "P6\n240 240\n255\n");
    for (size_t i = 0; i < sizeof memory; i += 2) {
        unsigned pixel = (unsigned)memory[i] << 8 | memory[i + 1];
        fputc((int)(pixel >> 11) * 255 / 31, file);
        fputc((int)(pixel >> 5 & 63) * 255 / 63, file);
        fputc((int)(pixel & 31) * 255 / 31, file);
    }
    return fclose(file) == 0;
}

int main(int argc, char **argv) {
    elf_firmware_t firmware = {0};
    if (argc != 3 || elf_read_firmware(argv[1], &firmware) != 0) {
        fprintf(stderr, "uno: give the firmware, an ELF file, and the name of the picture\n");
        return 2;
    }
    avr_t *avr = avr_make_mcu_by_name("atmega328p");
    avr_init(avr);
    avr->frequency = 16000000;
    avr_load_firmware(avr, &firmware);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_SPI_GETIRQ(0), SPI_IRQ_OUTPUT), on_byte, NULL);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('B'), 1), on_pin, NULL);
    while (received < sizeof memory) {
        int state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed || avr->cycle > 16000000ull * 600) {
            fprintf(stderr, "uno: the firmware stopped after %u bytes\n", received);
            return 1;
        }
    }
    if (!save(argv[2])) {
        fprintf(stderr, "uno: cannot write %s\n", argv[2]);
        return 1;
    }
    printf("digest %llu, %.1f s at 16 MHz\n", (unsigned long long)digest(), (double)avr->cycle / 16e6);
    return 0;
}
