#!/usr/bin/env python3
"""Trains a small detector of torchvision for some steps on frames that are made meanwhile; nothing is stored. Runs on a CPU.

    pip install . torch torchvision
    python3 scripts/train_from_stream.py [STEPS]
"""

import sys

import torch
from torch.utils.data import DataLoader
from torchvision.models.detection import ssdlite320_mobilenet_v3_large

import endless_city
from endless_city.torch import StreamDataset, collate_detection

steps = int(sys.argv[1]) if len(sys.argv) > 1 else 50
torch.manual_seed(0)
classes = len(endless_city.classes()) + 1  # and the background
model = ssdlite320_mobilenet_v3_large(weights=None, weights_backbone=None, num_classes=classes).train()
optimizer = torch.optim.SGD(model.parameters(), lr=0.01, momentum=0.9)
frames = StreamDataset(videos=8, size=(320, 180), fps=5, duration=3, vehicles=60, pedestrians=60, layers="rgb", mp4="none")
losses = []
for images, targets in DataLoader(frames, batch_size=2, collate_fn=collate_detection):
    loss = sum(model([image / 255 for image in images], targets).values())
    optimizer.zero_grad()
    loss.backward()
    optimizer.step()
    losses.append(loss.item())
    if len(losses) % 10 == 0:
        print(f"step {len(losses)}: loss {sum(losses[-10:]) / 10:.2f}")
    if len(losses) == steps:
        break
assert len(losses) == steps, f"only {len(losses)} steps"
if steps >= 50:
    assert sum(losses[-10:]) < sum(losses[:10]), "it learns nothing"
